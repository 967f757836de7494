#pragma once

// Contact impulses of the library in place of Box2D's contact solver, at the host's own time step.
//
//   b2World world(gravity);
//   halfspace::box2d::NarrowPhase narrow_phase(world);
//   halfspace::box2d::ImpulseMode impulses(narrow_phase);  // until the end of its scope
//   impulses.step(1 / 60.f, 8, 3);

#include <box2d/box2d.h>
#include <halfspace/halfspace.h>

#include <halfspace/box2d.hpp>
#include <memory>

namespace halfspace::box2d {

struct ImpulseOptions {
  int max_iterations = 100;  ///< sweeps of the solver per half step, >= 1
  double tolerance =
      1e-6;  ///< velocity that impulses may leave unbalanced, over gravity times time step, > 0
  bool locate_impacts = false;  ///< divides steps at impacts: rebounds are accurate, steps cost more
};

/// Computes the impulses between polygons by the library's contacts without springs: unilateral constraints
/// with Coulomb friction and restitution, both mixed as in Box2D. Box2D's solver and continuous collision
/// skip these pairs, and the bodies move in double precision.
///
/// A dynamic body takes part if it has one solid fixture, a polygon of the narrow phase, with the inertia of
/// uniform density, and is free to rotate. Two bodies that a filter, a joint or the host's listener separates
/// are excluded while they are near each other. Box2D's solver keeps the contacts of all other bodies,
/// joints, circles, edges and chains: they are coupled to the impulses from step to step, not within a step.
///
/// Not supported: sleep (step() wakes all bodies), sub-stepping of Box2D, friction, restitution and tangent
/// speed set on a contact, and PostSolve: see box2d_adapter/README.md.
///
/// It must be destroyed before its narrow phase: declare it after that. Its begin and end call no listener.
///
/// Thread rule: as for its world.
class ImpulseMode {
 public:
  /// Throws std::logic_error if the world is locked or the narrow phase already has a force or impulse mode,
  /// std::bad_alloc, and std::invalid_argument with the library's error text if it refuses the options.
  explicit ImpulseMode(NarrowPhase& narrow_phase, const ImpulseOptions& options = {});
  ~ImpulseMode();
  ImpulseMode(const ImpulseMode&) = delete;
  ImpulseMode& operator=(const ImpulseMode&) = delete;

  /// Replaces b2World::Step(). The iterations are those of Box2D, for what its solver keeps. It detects
  /// bodies and fixtures created, changed, moved or destroyed since the last step.
  ///
  /// Throws, before anything moves: std::invalid_argument if time_step is negative or not finite, or with the
  /// library's error text if it refuses a block, friction or restitution, or if blocks are too fast for it;
  /// std::logic_error if the world is locked or has sub-stepping enabled; std::bad_alloc.
  void step(float time_step, int velocity_iterations, int position_iterations);

  /// The largest velocity that the impulses of the last step left unbalanced, m/s. If it stays far above the
  /// tolerance, raise max_iterations.
  double unbalanced_velocity() const;

  /// The world of the library that mirrors the fixtures, with contacts and forces at the end of the last
  /// step; valid until the next step. The impulse mode owns it.
  const hs_world* world() const;

  /// The block of a fixture as of the last step; 0 if Box2D's solver keeps its contacts.
  hs_block block_of(const b2Fixture& fixture) const;

 private:
  class Impulses;
  std::unique_ptr<Impulses> make_impulses() const;
  void advance(float time_step);

  NarrowPhase::Installation& narrow_phase_;
  ImpulseOptions options_;
  std::unique_ptr<Impulses> impulses_;
};

}  // namespace halfspace::box2d
