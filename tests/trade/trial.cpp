#include "trial.h"

#include <algorithm>
#include <cmath>

namespace halfspace_trade {

Trial::Run::Run(Trial& trial, const Scene& scene) : trial_(trial), world_(build(scene, trial.setting_)) {
  time_step_ = trial.time_step_ = world_->time_step();
  all_ = std::lround(scene.duration / time_step_);
}

void Trial::Run::step(long steps) {
  steps = std::min(steps, all_ - done_);
  trial_.cpu_seconds_ += world_->step(steps);
  done_ += steps;
  time_ = double(done_) * time_step_;
  trial_.simulated_ += double(steps) * time_step_;
}

}  // namespace halfspace_trade
