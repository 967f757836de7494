#pragma once

#include <cmath>
#include <cstdint>
#include <tuple>

#include "geometry/numbers.h"

namespace halfspace {

/// Simulated time, computed from the number of steps since the time step was last set, so that rounding does
/// not accumulate.
class Clock {
 public:
  double time() const { return epoch_time_ + double(steps_ - epoch_step_) * time_step_ + passed_; }
  std::int64_t steps() const { return steps_; }
  double time_step() const { return time_step_; }
  /// The number of steps that have been divided.
  std::int64_t divided_steps() const { return divided_steps_; }
  /// The remaining time of the current step.
  double rest() const { return time_step_ - passed_; }

  /// Sets the time step; false if it is not positive. A new value applies from the current time on.
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

  /// State that choose() writes.
  auto epoch() { return std::tie(epoch_time_, epoch_step_, time_step_, passed_); }

  /// Validates the state read from a snapshot. A divided step that gets a new time step may be divided again,
  /// so divided_steps_ may exceed steps_.
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
  double epoch_time_ = 0;  // when the time step was last set, s
  std::int64_t epoch_step_ = 0;
  double time_step_ = 0;
  double passed_ = 0;  // part of a divided step so far, s
  std::int64_t steps_ = 0;
  std::int64_t divided_steps_ = 0;
};

}  // namespace halfspace
