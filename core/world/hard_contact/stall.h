#pragma once

#include <cmath>

#include "geometry/tolerances.h"

namespace halfspace {

/// Vertices of both blocks at faces of the other one are more constraints than degrees of freedom. Where they
/// contradict each other by rounding or rotation, the changes of sweeps never vanish.
class Stall {
 public:
  /// Takes the change of the next sweep. True when changes have not fallen in many sweeps.
  bool is_reached(double changed) {
    ++sweeps_;
    if (!(changed <= falling_ratio * least_)) return sweeps_ >= max_sweeps;
    least_ = changed;
    sweeps_ = 0;
    return false;
  }

 private:
  static constexpr int max_sweeps = 48;

  double least_ = HUGE_VAL;
  int sweeps_ = 0;  // since the least change
};

}  // namespace halfspace
