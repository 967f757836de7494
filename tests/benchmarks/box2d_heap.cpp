#include "box2d_heap.h"

#include <box2d/box2d.h>

#include "timing.h"

namespace halfspace_benchmark {
namespace {

constexpr float scale = 50;

b2Vec2 scaled(Point p) { return {scale * float(p.x), scale * float(p.y)}; }

void add_box(b2World& world, const Box& box) {
  const b2Vec2 low = scaled(box.low), high = scaled(box.high);
  b2BodyDef def;
  def.position = 0.5f * (low + high);
  b2PolygonShape shape;
  shape.SetAsBox(0.5f * (high.x - low.x), 0.5f * (high.y - low.y));
  world.CreateBody(&def)->CreateFixture(&shape, 0);
}

void add_grain(b2World& world, const Grain& grain, double shift) {
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = scaled({grain.position.x + shift, grain.position.y});
  def.angle = float(grain.angle);
  b2Vec2 vertices[3];
  for (std::size_t i = 0; i < 3; ++i) vertices[i] = scaled(grain.vertices[i]);
  b2PolygonShape shape;
  shape.Set(vertices, 3);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = 1;
  fixture.friction = 0.4663f;  // tan 25 degrees
  world.CreateBody(&def)->CreateFixture(&fixture);
}

}  // namespace

double box2d_step_seconds(const Bin& bin, int bins, int steps) {
  b2World world({0, -9.81f * scale});
  world.SetAllowSleeping(false);
  world.SetContinuousPhysics(
      false);  // at rest nothing tunnels, and its search grows with the square of the blocks
  add_box(world, floor_of(bin, bins));
  for (int i = 0; i <= bins; ++i) add_box(world, wall_of(bin, i));
  for (int i = 0; i < bins; ++i) {
    for (const Grain& grain : bin.grains) add_grain(world, grain, i * spacing(bin));
  }
  const auto step = [&] { world.Step(1 / 60.f, 8, 3); };
  for (int i = 0; i < steps; ++i) step();
  Passes passes;
  for (int i = 0; i < steps; ++i) passes.add(seconds_of(step));
  return passes.minimum();
}

}  // namespace halfspace_benchmark
