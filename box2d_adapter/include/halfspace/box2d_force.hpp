#pragma once

// Contact forces of the library in place of Box2D's contact solver, for scenes that want the accuracy of
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

/// Pairs that the narrow phase judges are passed by by Box2D's solver and by its continuous collision, and
/// take the forces of a law of the library instead, evaluated anew in each of several sub-steps. Joints, user
/// forces, gravity, damping of bodies, circles, edges, chains and all pairs that are left to Box2D stay
/// Box2D's, as do the broad phase, filters and listeners: see box2d_adapter/README.md.
///
/// It must end before its narrow phase does: declare it after. When it begins and ends nobody is woken and no
/// listener is called.
///
/// Thread rule: that of its world.
class ForceMode {
 public:
  /// `law` is that of all pairs but for the friction angle, that of Box2D's mixed friction, sqrt(f_a f_b).
  /// Stiffnesses are in N/m or Pa/m of a world that is 1 m thick. Cohesion and tensile strength have no
  /// effect, as no bonds are made. Throws std::logic_error when the world is locked or the narrow phase has a
  /// force mode already, std::bad_alloc, and std::invalid_argument with the library's reason when it refuses
  /// the law.
  ForceMode(NarrowPhase& narrow_phase, const hs_law_def& law);
  ~ForceMode();
  ForceMode(const ForceMode&) = delete;
  ForceMode& operator=(const ForceMode&) = delete;

  /// In place of b2World::Step(): as many equal sub-steps, each with so many iterations. What the host
  /// applies to bodies acts in all of them. Bodies and fixtures made, changed or destroyed since the last
  /// step are found.
  ///
  /// Throws std::invalid_argument, and nothing has moved, when the time step is negative or not finite, when
  /// there is no sub-step, when one is longer than stable_sub_step(), or when the library refuses a block;
  /// std::logic_error when the world is locked; std::bad_alloc, also after some of the sub-steps.
  void step(float time_step, int sub_steps, int velocity_iterations, int position_iterations);

  /// A sub-step below which no contact spring or dashpot can make energy, by stiffness, viscosity and mass; 0
  /// when nothing can touch. It grows shorter where a body has more than four contacts. A mass that the host
  /// has set by b2Body::SetMassData() is taken as spread evenly.
  double stable_sub_step();

  /// As many sub-steps as make each half as long as stable_sub_step(), so that contacts may come by in
  /// between.
  int sub_steps_for(float time_step);

  /// The world of the library that mirrors the fixtures: contacts, overlaps and forces of the last sub-step,
  /// until the next call of this class. It is evaluated before the sub-step moves the bodies. It ends with
  /// the force mode.
  const hs_world* world() const;

  /// The block of a fixture, since the last step; 0 when it has none: a sensor, disabled, left to Box2D, or
  /// no polygon.
  hs_block block_of(const b2Fixture& fixture) const;

 private:
  class Mirror;
  b2World& world_;
  std::unique_ptr<Mirror> mirror_;
};

}  // namespace halfspace::box2d
