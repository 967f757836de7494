#pragma once

// The same scene in both engines: a world of the library made from a Box2D world, and its motion brought
// back.

#include <box2d/box2d.h>
#include <halfspace/halfspace.h>

#include <cstdint>
#include <memory>

namespace halfspace::box2d {

/// A world of the library with the polygons, masses, friction, gravity, poses and velocities of a Box2D world
/// as they are when it is made.
///
/// Every polygon fixture of a static or kinematic body becomes a fixed or prescribed block, and every dynamic
/// body of one polygon fixture a rigid one of its mass. Two blocks rub with Box2D's mixed friction,
/// sqrt(f_a f_b). Left out: dynamic bodies of several fixtures or of another shape, circles, edges and chains
/// (a floor of these is not there), shapes attached to fixtures, sensors, disabled bodies, joints, fixed
/// rotation, gravity scales, inertia and centres of mass that a host has set, damping of bodies, restitution
/// (the law has damping instead), filters, and the skins: blocks that Box2D holds 1 to 2 cm apart have that
/// far to go until they meet.
class WorldCopy {
 public:
  /// `law` is that of all pairs but for the friction angle. The Box2D world and its bodies must live as long
  /// as the copy. Throws std::bad_alloc, and std::invalid_argument with the library's reason when it refuses
  /// the law, a shape or a pose.
  WorldCopy(b2World& source, const hs_law_def& law);
  ~WorldCopy();

  /// To be stepped by hs_world_step() and asked by all other functions; it ends with the copy.
  hs_world* world() const;

  /// The block of a fixture, 0 when it was left out.
  hs_block block_of(const b2Fixture& fixture) const;

  /// Dynamic bodies that were left out.
  std::int64_t bodies_left_out() const;

  /// Puts the dynamic bodies where their blocks are now, with their velocities. The angle of a body goes on
  /// from the one it has, by less than half a turn. The Box2D world must not be locked.
  void write_back();

 private:
  class Blocks;
  std::unique_ptr<Blocks> blocks_;
};

}  // namespace halfspace::box2d
