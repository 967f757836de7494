#pragma once

// The runner: one core, its clock, and what is kept of repeated passes.

#include <sched.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace_benchmark {

/// Keeps this thread on the core where it is now, so that no pass pays for a move. Returns the core, or -1 if
/// the system refuses.
inline int pin_to_this_core() {
  const int core = sched_getcpu();
  if (core < 0) return -1;
  cpu_set_t only_this;
  CPU_ZERO(&only_this);
  CPU_SET(std::size_t(core), &only_this);
  return sched_setaffinity(0, sizeof only_this, &only_this) == 0 ? core : -1;
}

/// Processor time of this thread so far, in s: what others run on the core in between is not counted.
inline double thread_seconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// Processor seconds that `work` takes on this thread.
template <class Work>
double seconds_of(Work&& work) {
  const double start = thread_seconds();
  work();
  return thread_seconds() - start;
}

/// Times of repeated passes. The minimum is the cost with the least disturbance by others, the median the
/// usual one.
class Passes {
 public:
  void add(double seconds) { seconds_.push_back(seconds); }
  double minimum() const { return *std::min_element(seconds_.begin(), seconds_.end()); }
  double median() const {
    std::vector<double> sorted = seconds_;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t middle = sorted.size() / 2;
    return sorted.size() % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
  }

 private:
  std::vector<double> seconds_;
};

/// Prints the wall time of work on one thread over that of the same on several: minima of passes that take
/// turns, so that both see the machine as busy as it is.
template <class OnOne, class OnSeveral>
void print_speed_up(double count, const char* of_what, int threads, int passes, OnOne&& on_one,
                    OnSeveral&& on_several) {
  const auto wall_seconds_of = [](auto&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  Passes one, several;
  for (int i = 0; i < passes; ++i) {
    one.add(wall_seconds_of(on_one));
    several.add(wall_seconds_of(on_several));
  }
  std::printf("%8.0f %s: %d threads are %.2f times as fast as one\n", count, of_what, threads,
              one.minimum() / several.minimum());
  std::fflush(stdout);
}

/// Was the option given?
inline bool has_option(int argc, char** argv, std::string_view name) {
  return std::any_of(argv + 1, argv + argc, [&](const char* given) { return name == given; });
}

/// The text after an option, or what is used without it.
inline std::string_view option_value(int argc, char** argv, std::string_view name,
                                     std::string_view otherwise) {
  const auto found = std::find_if(argv + 1, argv + argc, [&](const char* given) { return name == given; });
  return found < argv + argc - 1 ? found[1] : otherwise;
}

/// The number after `--threads`; 0 without it.
inline int threads_option(int argc, char** argv) {
  return std::atoi(std::string(option_value(argc, argv, "--threads", "0")).c_str());
}

}  // namespace halfspace_benchmark
