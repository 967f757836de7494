#pragma once

#include <chrono>
#include <string>

namespace halfspace::cli {

/// A progress bar with the time left on standard error; nothing if that is no terminal.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows the completed fraction and the position of the work. Redraws at most a few times per second.
  void show(double fraction, const std::string& where);

 private:
  using Clock = std::chrono::steady_clock;

  bool on_terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_{};
};

/// The text of the bar after `elapsed` seconds of work.
std::string progress_line(double fraction, const std::string& where, double elapsed);

}  // namespace halfspace::cli
