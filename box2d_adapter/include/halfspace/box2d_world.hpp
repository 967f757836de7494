#pragma once

// The same scene in both engines: makes a world of the library from a Box2D world, and copies its motion
// back.

#include <box2d/box2d.h>
#include <halfspace/halfspace.h>

#include <cstdint>
#include <memory>

namespace halfspace::box2d {

/// A world of the library with the current polygons, masses, friction, gravity, poses and velocities of a
/// Box2D world.
///
/// Polygon fixtures of static and kinematic bodies become fixed and prescribed blocks; dynamic bodies with
/// one polygon fixture become rigid blocks of their mass. Friction is Box2D's mixed friction sqrt(f_a f_b).
/// Not copied: dynamic bodies with several fixtures or another shape, circles, edges and chains (including
/// floors made of them), polygons that replace those of fixtures, sensors, disabled bodies, joints, fixed
/// rotation, gravity scales, inertia and centers of mass set by the host, damping of bodies, restitution (the
/// law has damping), filters, and skins: blocks that Box2D keeps 1 to 2 cm apart start with that gap.
class WorldCopy {
 public:
  /// `law` is the law of all pairs, except for the friction angle. The Box2D world and its bodies must
  /// outlive the copy. Throws std::bad_alloc, and std::invalid_argument with the library's error text if it
  /// refuses the law, a shape or a pose.
  WorldCopy(b2World& source, const hs_law_def& law);
  ~WorldCopy();

  /// For hs_world_step() and all other functions of worlds. The copy owns it.
  hs_world* world() const;

  /// The block of a fixture; 0 if it was not copied.
  hs_block block_of(const b2Fixture& fixture) const;

  /// Number of dynamic bodies that were not copied.
  std::int64_t bodies_left_out() const;

  /// Sets poses and velocities of the dynamic bodies to those of their blocks. The angle of a body changes by
  /// less than half a turn. The Box2D world must not be locked.
  void write_back();

 private:
  class Blocks;
  std::unique_ptr<Blocks> blocks_;
};

}  // namespace halfspace::box2d
