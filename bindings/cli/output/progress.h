#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace halfspace::cli {

/// Receives the completed fraction and the position of the work.
using ProgressListener = std::function<void(double fraction, const std::string& where)>;

/// Passes progress to a listener. Without one it is a bar with the time left on standard error, or nothing if
/// that is no terminal.
class Progress {
 public:
  explicit Progress(ProgressListener listener = {});
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows the completed fraction and the position of the work. A bar is redrawn a few times per second.
  void show(double fraction, const std::string& where);

 private:
  using Clock = std::chrono::steady_clock;

  ProgressListener listener_;
  bool on_terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_{};
};

/// The text of the bar after `elapsed` seconds of work.
std::string progress_line(double fraction, const std::string& where, double elapsed);

}  // namespace halfspace::cli
