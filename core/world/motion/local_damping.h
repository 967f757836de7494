#pragma once

#include <cmath>

namespace halfspace {

/// A force with Cundall's local damping: a fraction of its magnitude opposes the velocity.
inline double damped(double force, double velocity, double share) {
  return velocity == 0 ? force : force - share * std::abs(force) * (velocity > 0 ? 1 : -1);
}

/// Power of local damping over its coefficient, at `velocity`, for a damping force that opposes `opposed`.
inline double damped_power(double force, double opposed, double velocity) {
  return opposed == 0 ? 0 : std::abs(force) * (opposed > 0 ? velocity : -velocity);
}

}  // namespace halfspace
