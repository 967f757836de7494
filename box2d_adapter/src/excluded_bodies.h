#pragma once

#include <box2d/b2_world.h>

#include <unordered_set>

namespace halfspace::box2d {

/// Dynamic bodies with a neighbour that they must not collide with, by a filter, a joint, or the listener of
/// the host. In a world of the library all blocks collide, so Box2D's solver keeps these bodies.
class ExcludedBodies {
 public:
  /// Searches a world before a step.
  void find(b2World& world, float time_step);

  bool contains(const b2Body& body) const { return bodies_.count(&body) != 0; }

 private:
  void exclude(const b2Body& a, const b2Body& b);
  void exclude_joined(b2Body& body);
  void exclude_filtered(b2World& world, b2Fixture& fixture, float time_step);

  std::unordered_set<const b2Body*> bodies_;
};

}  // namespace halfspace::box2d
