#pragma once

// Blocks on slopes, by Box2D's solver or by forces of the library.

#include <halfspace/box2d_force.hpp>
#include <optional>

#include "world_fixture.h"

namespace halfspace_test {

constexpr double gravity = 10;

/// Equal stiffness and damping in both directions.
hs_law_def law_of(double stiffness, double damping);

/// A world in force mode when it has a law, else Box2D's own.
struct ForceWorld {
  explicit ForceWorld(const std::optional<hs_law_def>& law, b2Vec2 pull = {0, -float(gravity)})
      : world(pull) {
    if (!law) return;
    narrow_phase.emplace(world);
    forces.emplace(*narrow_phase, *law);
  }

  /// Of 1/60 s, in as many sub-steps as are needed.
  void step(int times = 1);
  int sub_steps() { return forces ? forces->sub_steps_for(1 / 60.f) : 1; }
  /// Between blocks that lie on each other.
  float rest_gap() const { return forces ? 0 : 2 * b2_polygonRadius - b2_linearSlop; }

  b2World world;
  std::optional<NarrowPhase> narrow_phase;
  std::optional<halfspace::box2d::ForceMode> forces;
};

/// How far a block of 1 m goes down a slope in a second, half a second after it was put there; and by 1/2 (g
/// sin - g mu cos) t^2 (Wang et al. 2021, section 4.1) from the velocity that it has by then, with the share
/// 1/n that steps of Euler's method add, which Box2D takes.
struct Slide {
  double distance;
  double expected;
};
Slide slide_down(const std::optional<hs_law_def>& law, double slope, double friction);

/// Boxes of 2 x 0.5 m on each other on a slope.
class SlopedStack {
 public:
  SlopedStack(const std::optional<hs_law_def>& law, int height, float slope, float friction);

  /// Of all pairs.
  void set_friction(float friction);
  /// How far the topmost box goes down the slope in so many steps.
  double slide(int steps);

 private:
  ForceWorld arena_;
  b2Rot turn_;
  const b2Body* top_ = nullptr;
};

/// How far the topmost box goes down in 5 s: half a second after the stack has been put there, ...
double creep_let_go(const std::optional<hs_law_def>& law, int height, float slope, float friction);
/// ... or once it has lain for 5 s with four times the friction, and that has fallen to what is given.
double creep_settled(const std::optional<hs_law_def>& law, int height, float slope, float friction);

/// The speed after an undamped head-on bounce of two blocks of 1 kg at 1 m/s each, and omega h.
struct Bounce {
  double speed;
  double omega_h;
};
Bounce bounce_head_on(double stiffness, int sub_steps_over_needed, bool are_bullets);

}  // namespace halfspace_test
