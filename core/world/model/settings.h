#pragma once

#include <cstdint>

#include "geometry/numbers.h"
#include "geometry/vector.h"
#include "narrow_phase/contact.h"

namespace halfspace {

/// Treatment of a step in which two blocks would move far relative to the thinner one.
enum class FastBlocks : std::int32_t { divide = 0, refuse = 1 };

/// Settings of a world, as in hs_world_def.
template <int D>
struct WorldSettings {
  Vector<D> gravity = Vector<D>::Zero();
  double time_step = 0;  // s; 0: safety times the stable time step
  double safety = 0.5;
  double local_damping = 0;
  double mass_damping = 0;
  double skin = 0.1;
  double potential_length = 0;  // H of potential laws, m; 0: mean edge length at the first force evaluation
  DetectOptions detect;
  FastBlocks fast_blocks = FastBlocks::divide;
  double sleep_tolerance = 0;       // maximum displacement error of a block by sleep, m; 0: no sleep
  double impulse_tolerance = 1e-6;  // unbalanced velocity over gravity times step, without springs
  std::int32_t max_impulse_iterations = 200;  // likewise
  std::int32_t locate_impacts = 0;            // divide steps at impacts without springs

  /// Validates the state read from a snapshot.
  bool is_consistent() const {
    return gravity.allFinite() && is_nonnegative(time_step) && is_fraction(safety, 1) &&
           is_fraction(local_damping, 1) && is_nonnegative(mass_damping) && is_fraction(skin, 1) &&
           is_nonnegative(potential_length) && is_fraction(detect.parallel_angle, 0.5) &&
           is_fraction(detect.vertex_zone, 0.5) && is_nonnegative(sleep_tolerance) &&
           (fast_blocks == FastBlocks::divide || fast_blocks == FastBlocks::refuse) &&
           is_positive(impulse_tolerance) && max_impulse_iterations > 0 && locate_impacts >= 0 &&
           locate_impacts <= 1;
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(gravity, time_step, safety, local_damping, mass_damping, skin, potential_length, detect,
            sleep_tolerance, fast_blocks, impulse_tolerance, max_impulse_iterations, locate_impacts);
  }
};

}  // namespace halfspace
