#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

namespace halfspace::cli {

/// Work for a child process, which exits with its return value. What it prints goes to a file.
struct Job {
  std::size_t number = 0;
  std::function<int()> work;
  std::filesystem::path log;
};

struct JobEnd {
  std::size_t number = 0;
  int status = 0;  ///< exit code; 128 + n after signal n
  double seconds = 0;
};

/// Runs jobs in child processes, so many at once, in their order. However one ends, the others go on. After
/// an interrupt none begins, and the running ones are interrupted. `ended` is called after each, `wait` while
/// they run. @throws std::runtime_error if there can be no child
void run_in_children(const std::vector<Job>& jobs, std::size_t at_once,
                     const std::function<void(const JobEnd&)>& ended,
                     const std::function<void(std::size_t running)>& wait);

}  // namespace halfspace::cli
