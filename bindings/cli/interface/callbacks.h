#pragma once

#include "common/interrupt.h"
#include "halfspace/scene.h"
#include "output/progress.h"

namespace halfspace::cli {

/// Work that callbacks of the calling thread may interrupt.
class InterruptibleWork {
 public:
  InterruptibleWork() { interrupt_this_thread(false); }
  ~InterruptibleWork() { interrupt_this_thread(false); }
  InterruptibleWork(const InterruptibleWork&) = delete;
  InterruptibleWork& operator=(const InterruptibleWork&) = delete;
};

/// Passes progress to a callback, at most some ten times per second; ends the work if that says so.
ProgressListener listener_of(hs_scene_progress progress, void* user);

}  // namespace halfspace::cli
