#pragma once

#include <cmath>
#include <cstdint>
#include <tuple>

#include "geometry/numbers.h"

namespace halfspace {

/// Time in steps. It is counted from when the step was last chosen, so that it does not gather rounding.
class Clock {
 public:
  double time() const { return epoch_time_ + double(steps_ - epoch_step_) * time_step_ + passed_; }
  std::int64_t steps() const { return steps_; }
  double time_step() const { return time_step_; }
  /// The number of steps that have been divided.
  std::int64_t divided_steps() const { return divided_steps_; }
  /// The part of the step that is still to come.
  double rest() const { return time_step_ - passed_; }

  /// False for what is no step. Another one than before begins where time has come to.
  bool choose(double time_step) {
    if (!is_positive(time_step)) return false;
    if (time_step == time_step_) return true;
    epoch_time_ = time();
    epoch_step_ = steps_;
    passed_ = 0;
    time_step_ = time_step;
    return true;
  }
  void pass_part(double duration) {
    if (passed_ == 0) ++divided_steps_;
    passed_ += duration;
  }
  void complete_step() {
    passed_ = 0;
    ++steps_;
  }

  /// All that choosing a step writes to.
  auto epoch() { return std::tie(epoch_time_, epoch_step_, time_step_, passed_); }

  /// False for what no clock can be, after reading a snapshot. A step that is divided, and chosen anew before
  /// its end, is divided more than once.
  bool is_consistent() const {
    constexpr std::int64_t max_steps = std::int64_t(1) << 62;
    return is_nonnegative(time_step_) && is_finite(epoch_time_) && epoch_step_ >= 0 &&
           steps_ >= epoch_step_ && steps_ <= max_steps && divided_steps_ >= 0 &&
           divided_steps_ <= max_steps && passed_ >= 0 && passed_ <= time_step_;
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(epoch_time_, epoch_step_, time_step_, passed_, steps_, divided_steps_);
  }

 private:
  double epoch_time_ = 0;  // when the time step was last chosen
  std::int64_t epoch_step_ = 0;
  double time_step_ = 0;
  double passed_ = 0;  // of a step that is divided and not at its end
  std::int64_t steps_ = 0;
  std::int64_t divided_steps_ = 0;
};

}  // namespace halfspace
