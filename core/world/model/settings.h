#pragma once

#include <cstdint>

#include "geometry/numbers.h"
#include "geometry/vector.h"
#include "narrow_phase/contact.h"

namespace halfspace {

/// A step in which two blocks would move far against the thinner of them is divided or refused.
enum class FastBlocks : std::int32_t { divide = 0, refuse = 1 };

/// How a world is stepped.
template <int D>
struct WorldSettings {
  Vector<D> gravity = Vector<D>::Zero();
  double time_step = 0;  // 0: safety times the stable one
  double safety = 0.5;
  double local_damping = 0;
  double mass_damping = 0;
  double skin = 0.1;
  double potential_length = 0;  // H of potential laws; 0: mean length of the edges when forces are first used
  DetectOptions detect;
  FastBlocks fast_blocks = FastBlocks::divide;
  double sleep_tolerance = 0;  // of its way that a block may miss over a run by sleep; 0: none sleeps

  /// False for what no settings can be, after reading a snapshot.
  bool is_consistent() const {
    return gravity.allFinite() && is_nonnegative(time_step) && is_fraction(safety, 1) &&
           is_fraction(local_damping, 1) && is_nonnegative(mass_damping) && is_fraction(skin, 1) &&
           is_nonnegative(potential_length) && is_fraction(detect.parallel_angle, 0.5) &&
           is_fraction(detect.vertex_zone, 0.5) && is_nonnegative(sleep_tolerance) &&
           (fast_blocks == FastBlocks::divide || fast_blocks == FastBlocks::refuse);
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(gravity, time_step, safety, local_damping, mass_damping, skin, potential_length, detect,
            sleep_tolerance, fast_blocks);
  }
};

}  // namespace halfspace
