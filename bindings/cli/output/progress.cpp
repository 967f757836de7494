#include "output/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "common/text.h"

namespace halfspace::cli {
namespace {

constexpr int bar_width = 30;

std::string clock_text(double seconds) {
  const long whole = std::lround(seconds);
  char buffer[32];
  if (whole >= 3600) {
    std::snprintf(buffer, sizeof buffer, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  } else {
    std::snprintf(buffer, sizeof buffer, "%ld:%02ld", whole / 60, whole % 60);
  }
  return buffer;
}

}  // namespace

std::string progress_line(double fraction, const std::string& where, double elapsed) {
  const double done = std::clamp(fraction, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(done * bar_width);
  std::string line = '[' + std::string(filled, '#') + std::string(bar_width - filled, ' ') + "] ";
  line += decimals(100 * done, 0) + " %  " + where;
  if (done > 0) line += "  " + clock_text(elapsed * (1 - done) / done) + " left";
  return line;
}

Progress::Progress(ProgressListener listener)
    : listener_(std::move(listener)), on_terminal_(!listener_ && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\033[K", stderr);  // leaves a clean line
}

void Progress::show(double fraction, const std::string& where) {
  if (listener_) return listener_(fraction, where);
  const Clock::time_point now = Clock::now();
  if (!on_terminal_ || (drawn_ && now - last_drawn_ < std::chrono::milliseconds(200))) return;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  std::fprintf(stderr, "\r\033[K%s", progress_line(fraction, where, elapsed).c_str());
  std::fflush(stderr);
  drawn_ = true;
  last_drawn_ = now;
}

}  // namespace halfspace::cli
