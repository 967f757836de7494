#pragma once

#include <box2d/box2d.h>

#include <cstring>
#include <halfspace/box2d.hpp>
#include <memory>
#include <vector>

#include "posed_polygons.h"

namespace halfspace_test {

using halfspace::box2d::FixtureGeometry;
using halfspace::box2d::NarrowPhase;

inline void step(b2World& world, int times = 1) {
  for (int i = 0; i < times; ++i) world.Step(1 / 60.f, 8, 3);
}

inline b2Fixture& add_polygon(b2World& world, const b2PolygonShape& shape, b2Vec2 at, float angle = 0,
                              b2BodyType type = b2_dynamicBody) {
  b2BodyDef body;
  body.type = type;
  body.position = at;
  body.angle = angle;
  return *world.CreateBody(&body)->CreateFixture(&shape, 1);
}

inline b2PolygonShape box_shape(float half_width, float half_height) {
  b2PolygonShape shape;
  shape.SetAsBox(half_width, half_height);
  return shape;
}

/// Boxes of 1 m, one on the other, on a floor.
inline void add_stack(b2World& world, int height) {
  add_polygon(world, box_shape(20, 1), {0, -1}, 0, b2_staticBody);
  for (int i = 0; i < height; ++i) add_polygon(world, box_shape(0.5f, 0.5f), {0, 0.52f + 1.01f * float(i)});
}

inline std::vector<b2Contact*> contacts_of(b2World& world) {
  std::vector<b2Contact*> contacts;
  for (b2Contact* c = world.GetContactList(); c; c = c->GetNext()) contacts.push_back(c);
  return contacts;
}

/// All that moves, bit by bit.
inline std::vector<float> state_of(b2World& world) {
  std::vector<float> state;
  for (b2Body* b = world.GetBodyList(); b; b = b->GetNext()) {
    const b2Vec2 p = b->GetPosition(), v = b->GetLinearVelocity();
    state.insert(state.end(), {p.x, p.y, b->GetAngle(), v.x, v.y, b->GetAngularVelocity()});
  }
  return state;
}

/// The manifold that a narrow phase gives the pair; without one, Box2D's own.
inline b2Manifold manifold_of(const PosedPolygons& pair, bool by_halfspaces) {
  b2World world({0, 0});
  b2Manifold manifold;
  manifold.pointCount = 0;
  if (!by_halfspaces) {
    b2CollidePolygons(&manifold, &pair.a, pair.transform_a(), &pair.b, pair.transform_b());
    return manifold;
  }
  const NarrowPhase narrow_phase(world);
  // Of two fixtures the one made last is the contact's B.
  add_polygon(world, pair.a, pair.at_a, pair.angle_a);
  add_polygon(world, pair.b, pair.at_b, pair.angle_b);
  world.Step(0, 1, 1);
  for (b2Contact* contact : contacts_of(world)) manifold = *contact->GetManifold();
  return manifold;
}

}  // namespace halfspace_test
