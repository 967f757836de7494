#include "box2d_scenes.h"

#include "box2d_polygon.h"

namespace halfspace_benchmark {
namespace {

void add_block(b2World& world, const b2PolygonShape& shape, b2Vec2 at) {
  b2BodyDef body;
  body.type = b2_dynamicBody;
  body.position = at;
  world.CreateBody(&body)->CreateFixture(&shape, 5);
}

}  // namespace

void add_pyramid(b2World& world) {
  b2PolygonShape shape;
  shape.SetAsBox(40, 1, {0, -1}, 0);
  const b2BodyDef floor;
  world.CreateBody(&floor)->CreateFixture(&shape, 0);
  shape.SetAsBox(0.5f, 0.5f);
  constexpr int rows = 20;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i)
      add_block(world, shape,
                {1.125f * (float(i) - 0.5f * float(rows - row - 1)), 0.55f + 1.05f * float(row)});
  }
}

void add_drum(b2World& world) {
  b2BodyDef drum;
  drum.type = b2_kinematicBody;
  drum.angularVelocity = float(2 * pi / 10);
  b2Body& walls = *world.CreateBody(&drum);
  b2PolygonShape wall;
  for (const b2Vec2 side : {b2Vec2(1, 0), b2Vec2(0, 1), b2Vec2(-1, 0), b2Vec2(0, -1)}) {
    wall.SetAsBox(side.x != 0 ? 0.5f : 10.5f, side.y != 0 ? 0.5f : 10.5f, 10 * side, 0);
    walls.CreateFixture(&wall, 0);
  }
  Random random(1);
  for (int i = 0; i < 300; ++i)
    add_block(world, random_box2d_shape(0.25, 0.35, random),
              {-6.f + 0.7f * float(i % 18), -6.f + 0.7f * float(i / 18)});
}

}  // namespace halfspace_benchmark
