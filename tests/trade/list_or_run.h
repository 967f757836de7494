#pragma once

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>
#include <vector>

namespace halfspace_trade {

/// The main function of a program of numbered cases: `list` prints their names, `run N` runs one and prints a
/// row.
template <class Case>
int list_or_run(int argc, char** argv, std::vector<Case> (*cases)(), void (*print_name)(const Case&),
                void (*run)(const Case&)) {
  try {
    const std::vector<Case> all = cases();
    const std::string_view verb = argc > 1 ? argv[1] : "";
    if (verb == "list" && argc == 2) {
      for (const Case& c : all) print_name(c), std::printf("\n");
      return 0;
    }
    const std::size_t number = argc == 3 ? std::size_t(std::atol(argv[2])) : all.size();
    if (verb == "run" && number < all.size()) {
      run(all[number]);
      return 0;
    }
    std::fprintf(stderr, "usage: %s list | run N, of %zu\n", argv[0], all.size());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

}  // namespace halfspace_trade
