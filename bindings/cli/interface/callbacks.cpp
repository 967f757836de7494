#include "interface/callbacks.h"

#include <algorithm>
#include <chrono>
#include <string>

namespace halfspace::cli {

ProgressListener listener_of(hs_scene_progress progress, void* user) {
  using Clock = std::chrono::steady_clock;
  return [progress, user, last = Clock::time_point()](double fraction, const std::string& where) mutable {
    const Clock::time_point now = Clock::now();
    if (!progress || now - last < std::chrono::milliseconds(100)) return;
    last = now;
    if (progress(user, std::min(fraction, 1.0), where.c_str()) != 0) interrupt_this_thread(true);
  };
}

}  // namespace halfspace::cli
