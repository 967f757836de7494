#pragma once

#include <chrono>
#include <string>

namespace halfspace::cli {

/// A bar with the time left on standard error, if that is a terminal; nothing at all if not.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows what share is done, and in words where the work is. Redraws a few times a second at most.
  void show(double share, const std::string& where);

 private:
  using Clock = std::chrono::steady_clock;

  bool on_terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_{};
};

/// What the bar looks like after `elapsed` seconds of work.
std::string progress_line(double share, const std::string& where, double elapsed);

}  // namespace halfspace::cli
