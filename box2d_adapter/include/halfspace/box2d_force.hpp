#pragma once

// Contact forces of the library in place of Box2D's contact solver, for scenes that need the accuracy of
// discrete elements in a Box2D host.
//
//   b2World world(gravity);
//   halfspace::box2d::NarrowPhase narrow_phase(world);
//   halfspace::box2d::ForceMode forces(narrow_phase, law);  // until the end of its scope
//   forces.step(1 / 60.f, forces.sub_steps_for(1 / 60.f), 8, 3);

#include <box2d/box2d.h>
#include <halfspace/halfspace.h>

#include <halfspace/box2d.hpp>
#include <memory>

namespace halfspace::box2d {

/// Applies the forces of a contact law of the library to the pairs of the narrow phase, evaluated in each of
/// several sub-steps. Box2D's solver and continuous collision skip these pairs. Joints, user forces, gravity,
/// damping of bodies, circles, edges, chains, all pairs left to Box2D, broad phase, filters and listeners
/// remain Box2D's: see box2d_adapter/README.md.
///
/// It must be destroyed before its narrow phase: declare it after that. Its begin and end wake no body and
/// call no listener.
///
/// Thread rule: as for its world.
class ForceMode {
 public:
  /// `law` is the law of all pairs, except for the friction angle, which follows from Box2D's mixed friction
  /// sqrt(f_a f_b). Stiffnesses are in N/m or Pa/m, for a thickness of 1 m. Cohesion and tensile strength are
  /// ignored. Throws std::logic_error if the world is locked or the narrow phase already has a force or
  /// impulse mode, std::bad_alloc, and std::invalid_argument with the library's error text if it refuses the
  /// law, or if the law has no springs.
  ForceMode(NarrowPhase& narrow_phase, const hs_law_def& law);
  ~ForceMode();
  ForceMode(const ForceMode&) = delete;
  ForceMode& operator=(const ForceMode&) = delete;

  /// Replaces b2World::Step(): steps in equal sub-steps with the given iterations each. Forces that the host
  /// applies to bodies act in all sub-steps. It detects bodies and fixtures created, changed or destroyed
  /// since the last step.
  ///
  /// Throws std::invalid_argument, before anything moves, if time_step is negative or not finite, if
  /// sub_steps is below 1, if a sub-step is longer than stable_sub_step(), or if the library refuses a block;
  /// std::logic_error if the world is locked; std::bad_alloc, possibly after some sub-steps.
  void step(float time_step, int sub_steps, int velocity_iterations, int position_iterations);

  /// Returns the stable sub-step by stiffness, viscosity and mass, s, below which no contact spring or
  /// dashpot creates energy; 0 if no contact is possible. It decreases if a body has more than four contacts.
  /// A mass set by b2Body::SetMassData() is assumed uniform.
  double stable_sub_step();

  /// Returns the number of sub-steps of half of stable_sub_step(), which leaves a margin for new contacts.
  int sub_steps_for(float time_step);

  /// The world of the library that mirrors the fixtures, with contacts, overlaps and forces at the begin of
  /// the last sub-step; valid until the next call of this class. The force mode owns it.
  const hs_world* world() const;

  /// The block of a fixture as of the last step; 0 if it is a sensor, disabled, left to Box2D, or no polygon.
  hs_block block_of(const b2Fixture& fixture) const;

 private:
  class Forces;
  b2World& world_;
  std::unique_ptr<Forces> forces_;
};

}  // namespace halfspace::box2d
