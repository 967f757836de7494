#pragma once

// What the tests of force mode put into their worlds.

#include "catch.h"
#include "force_scenes.h"

namespace halfspace_test {

inline hs_contact only_contact_of(const ForceWorld& arena) {
  hs_contact contact{};
  std::int64_t count = 0;
  REQUIRE(hs_world_get_contacts(arena.forces->world(), &contact, 1, &count) == HS_OK);
  REQUIRE(count == 1);
  return contact;
}

inline b2Body& add_box(b2World& world, b2Vec2 at, float angle = 0, b2BodyType type = b2_dynamicBody) {
  return *add_polygon(world, box_shape(0.5f, 0.5f), at, angle, type).GetBody();
}

inline void add_floor(b2World& world, b2Vec2 at = {0, 0}) {
  add_polygon(world, box_shape(20, 1), at + b2Vec2(0, -1), 0, b2_staticBody);
}

inline double distance(const b2Body& a, const b2Body& b) {
  return (a.GetPosition() - b.GetPosition()).Length();
}

}  // namespace halfspace_test
