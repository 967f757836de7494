// What a host of Box2D relies on, with the narrow phase and without: rest, events, sensors, bullets,
// friction, restitution, conveyor belts. The first case is the setting of Box2D's own unit test "hello
// world".

#include <algorithm>
#include <cmath>
#include <optional>

#include "catch.h"
#include "world_fixture.h"

namespace halfspace_test {
namespace {

/// A world that meets polygons by half-spaces, or by Box2D.
struct Arena {
  explicit Arena(bool by_halfspaces, b2Vec2 gravity = {0, -10}) : world(gravity) {
    if (by_halfspaces) narrow_phase.emplace(world);
  }

  b2World world;
  std::optional<NarrowPhase> narrow_phase;
};

class PairCache : public b2ContactListener {
 public:
  void BeginContact(b2Contact*) override { ++begun; }
  void EndContact(b2Contact*) override { ++ended; }
  void PreSolve(b2Contact* contact, const b2Manifold*) override { contact->SetTangentSpeed(belt_speed); }
  void PostSolve(b2Contact*, const b2ContactImpulse* impulse) override {
    for (int i = 0; i < impulse->count; ++i) pushed += impulse->normalImpulses[i];
  }

  float belt_speed = 0;
  int begun = 0;
  int ended = 0;
  float pushed = 0;
};

b2Body& add_floor(b2World& world, float friction = 0.6f) {
  b2Fixture& floor = add_polygon(world, box_shape(50, 10), {0, -10}, 0, b2_staticBody);
  floor.SetFriction(friction);
  return *floor.GetBody();
}

}  // namespace

TEST_CASE("a box falls 3 m and lies at 1.01 m a second later") {
  for (const bool by_halfspaces : {false, true}) {
    Arena arena(by_halfspaces);
    add_floor(arena.world);
    b2Fixture& box = add_polygon(arena.world, box_shape(1, 1), {0, 4});
    for (int i = 0; i < 60; ++i) arena.world.Step(1 / 60.f, 6, 2);
    CHECK(std::abs(box.GetBody()->GetPosition().x) < 0.01f);
    CHECK(std::abs(box.GetBody()->GetPosition().y - 1.01f) < 0.01f);
    CHECK(std::abs(box.GetBody()->GetAngle()) < 0.01f);
  }
}

TEST_CASE("a listener sees the same bounces, and impulses that carry the weight") {
  PairCache witnesses[2];
  for (const bool by_halfspaces : {false, true}) {
    PairCache& witness = witnesses[by_halfspaces];
    Arena arena(by_halfspaces);
    arena.world.SetAllowSleeping(false);
    arena.world.SetContactListener(&witness);
    add_floor(arena.world);
    b2Fixture& box = add_polygon(arena.world, box_shape(0.5f, 0.5f), {0, 4});
    box.SetRestitution(0.5f);
    step(arena.world, 300);
    CHECK(witness.begun == witness.ended + 1);
    witness.pushed = 0;
    step(arena.world, 60);
    CHECK(witness.pushed == Approx(10 * 1.0).epsilon(0.01));  // 1 kg for a second
  }
  CHECK(witnesses[0].begun > 2);
  CHECK(witnesses[0].begun == witnesses[1].begun);
}

TEST_CASE("a bullet does not pass a thin wall") {
  for (const bool by_halfspaces : {false, true}) {
    Arena arena(by_halfspaces, {0, 0});
    add_polygon(arena.world, box_shape(0.02f, 5), {10, 0}, 0, b2_staticBody);
    b2Body& bullet = *add_polygon(arena.world, box_shape(0.1f, 0.1f), {0, 0}, 0.3f).GetBody();
    bullet.SetBullet(true);
    bullet.SetLinearVelocity({100, 0});
    float farthest = 0;
    for (int i = 0; i < 60; ++i) {
      step(arena.world);
      farthest = std::max(farthest, bullet.GetPosition().x);
    }
    CHECK(farthest > 9.5f);
    CHECK(farthest < 10);
  }
}

TEST_CASE("sensors begin and end as they do") {
  for (const bool by_halfspaces : {false, true}) {
    PairCache witness;
    Arena arena(by_halfspaces);
    arena.world.SetContactListener(&witness);
    add_polygon(arena.world, box_shape(1, 1), {0, 0}, 0, b2_staticBody).SetSensor(true);
    b2Fixture& box = add_polygon(arena.world, box_shape(0.5f, 0.5f), {0, 3});
    step(arena.world, 120);
    CHECK(witness.begun == 1);
    CHECK(witness.ended == 1);
    CHECK(box.GetBody()->GetPosition().y < -10);
  }
}

TEST_CASE("a block stays on a slope below the angle of friction, and slides above it as Coulomb says") {
  const float friction = 0.5f;
  for (const bool by_halfspaces : {false, true}) {
    for (const float slope : {0.45f, 0.6f}) {
      const float angle = std::atan(slope);
      const b2Rot turn(angle);
      Arena arena(by_halfspaces);
      arena.world.SetAllowSleeping(false);
      add_polygon(arena.world, box_shape(200, 1), {0, 0}, angle, b2_staticBody).SetFriction(friction);
      b2Fixture& block = add_polygon(arena.world, box_shape(1, 0.5f), 1.515f * turn.GetYAxis(), angle);
      block.SetFriction(friction);
      step(arena.world, 60);
      const b2Vec2 from = block.GetBody()->GetPosition(), speed = block.GetBody()->GetLinearVelocity();
      step(arena.world, 120);
      if (slope < friction) {
        CHECK((block.GetBody()->GetPosition() - from).Length() < 0.02f);
      } else {
        const float gained = (block.GetBody()->GetLinearVelocity() - speed).Length();
        CHECK(gained == Approx(2 * 10 * (turn.s - friction * turn.c)).epsilon(0.02));
      }
    }
  }
}

TEST_CASE("a belt that a listener sets moving carries a box") {
  for (const bool by_halfspaces : {false, true}) {
    PairCache witness;
    witness.belt_speed = 2;
    Arena arena(by_halfspaces);
    arena.world.SetContactListener(&witness);
    add_floor(arena.world);
    b2Fixture& box = add_polygon(arena.world, box_shape(0.5f, 0.5f), {0, 0.515f});
    step(arena.world, 120);
    CHECK(std::abs(box.GetBody()->GetLinearVelocity().x) == Approx(2).epsilon(0.02));
  }
}

TEST_CASE("fixtures that a joint or a filter keeps apart stay so") {
  for (const bool by_halfspaces : {false, true}) {
    Arena arena(by_halfspaces);
    add_floor(arena.world);
    b2Fixture& ghost = add_polygon(arena.world, box_shape(0.5f, 0.5f), {0, 0.515f});
    step(arena.world, 10);
    CHECK(ghost.GetBody()->GetPosition().y > 0.5f);
    b2Filter nothing;
    nothing.maskBits = 0;
    ghost.SetFilterData(nothing);
    ghost.GetBody()->SetAwake(true);
    step(arena.world, 60);
    CHECK(ghost.GetBody()->GetPosition().y < -1);
  }
}

}  // namespace halfspace_test
