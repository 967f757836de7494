#pragma once

#include <cmath>

namespace halfspace {

/// A force with Cundall's damping: a share of it opposes the velocity.
inline double damped(double force, double velocity, double share) {
  return velocity == 0 ? force : force - share * std::abs(force) * (velocity > 0 ? 1 : -1);
}

/// Rate of what local damping takes when it opposes one velocity and the block has another by now.
inline double damped_power(double force, double opposed, double velocity) {
  return opposed == 0 ? 0 : std::abs(force) * (opposed > 0 ? velocity : -velocity);
}

}  // namespace halfspace
