#pragma once

// What the benchmarks of single pairs have in common, in the plane and in space.

#include <cstdio>
#include <cstdlib>

#include "timing.h"

namespace halfspace_benchmark {

/// A set of pairs, all laid at one separation.
struct GapSet {
  const char* name;
  double separation;  ///< share of the size; < 0 is overlap
};
inline constexpr GapSet gap_sets[] = {{"far", 0.1}, {"near", 1e-3}, {"touch", -1e-3}, {"deep", -0.2}};

/// Times a set is gone through.
inline constexpr int passes = 7;

struct Sizes {
  int pairs;   ///< of a set
  int shapes;  ///< that they share
};

/// From `--quick` and `--shapes N`. No shapes when N is not a number of them; that is told on the error
/// stream.
inline Sizes read_sizes(int argc, char** argv, const char* program) {
  const Sizes sizes{has_option(argc, argv, "--quick") ? 128 : 4096,
                    std::atoi(option_value(argc, argv, "--shapes", "64").data())};
  if (sizes.shapes < 1)
    std::fprintf(stderr, "%s: --shapes must be followed by a number of shapes, 1 or more\n", program);
  return sizes;
}

}  // namespace halfspace_benchmark
