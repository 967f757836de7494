#pragma once

#include <box2d/b2_world.h>

#include <cmath>
#include <stdexcept>

#include "installation.h"

namespace halfspace::box2d {

// Requirements of force mode and impulse mode on their host.

inline void require_unlocked(const b2World& world) {
  if (world.IsLocked()) throw std::logic_error("the world is locked");
}

inline void require_can_begin(const NarrowPhase::Installation& narrow_phase) {
  require_unlocked(narrow_phase.world());
  if (narrow_phase.has_mode)
    throw std::logic_error("the narrow phase has a force or impulse mode already; destroy that first");
}

inline void require_time_step(float time_step) {
  if (!(time_step >= 0 && std::isfinite(time_step)))
    throw std::invalid_argument("time_step must be finite and >= 0");
}

}  // namespace halfspace::box2d
