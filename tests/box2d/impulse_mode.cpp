// Contact impulses of the library in Box2D worlds at the host's step of 1/60 s, against closed forms.

#include <cmath>
#include <halfspace/box2d_impulse.hpp>
#include <limits>
#include <stdexcept>
#include <vector>

#include "catch.h"
#include "force_arena.h"

namespace halfspace_test {
namespace {

using halfspace::box2d::ImpulseMode;
using halfspace::box2d::ImpulseOptions;
using halfspace::box2d::Options;

struct ImpulseWorld {
  explicit ImpulseWorld(const ImpulseOptions& options = {}, const Options& narrow = {},
                        b2Vec2 pull = {0, -float(gravity)})
      : world(pull), narrow_phase(world, narrow), impulses(narrow_phase, options) {}

  void step(int times = 1) {
    for (int i = 0; i < times; ++i) impulses.step(1 / 60.f, 8, 3);
  }

  b2World world;
  NarrowPhase narrow_phase;
  ImpulseMode impulses;
};

/// Boxes of 1 m, each flush with the one below.
std::vector<b2Body*> add_flush_stack(b2World& world, int height, float x = 0) {
  std::vector<b2Body*> boxes;
  for (int i = 0; i < height; ++i) boxes.push_back(&add_box(world, {x, 0.5f + float(i)}));
  return boxes;
}

b2Body& add_edge_floor(b2World& world) {
  const b2BodyDef def;
  b2Body& floor = *world.CreateBody(&def);
  b2EdgeShape edge;
  edge.SetTwoSided({-20, 0}, {20, 0});
  floor.CreateFixture(&edge, 0);
  return floor;
}

}  // namespace

// Positions of 10 m are floats with a spacing of 1e-6 m.
TEST_CASE("impulses hold a stack of ten in place") {
  ImpulseWorld arena;
  add_floor(arena.world);
  const std::vector<b2Body*> boxes = add_flush_stack(arena.world, 10);
  arena.step(300);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    CHECK(distance(*boxes[i], *boxes[0]) == Approx(double(i)).margin(1e-6));
    CHECK(std::abs(boxes[i]->GetPosition().y - 0.5 - double(i)) < 1e-6);
    CHECK(std::abs(boxes[i]->GetPosition().x) < 1e-6);
    CHECK(boxes[i]->GetLinearVelocity().Length() < 1e-6);
  }
  CHECK(arena.impulses.unbalanced_velocity() < 1e-5 * gravity / 60);
}

TEST_CASE("impulses hold a heavy box on a light one") {
  ImpulseWorld arena;
  add_floor(arena.world);
  const std::vector<b2Body*> boxes = add_flush_stack(arena.world, 2);
  boxes[1]->GetFixtureList()->SetDensity(1000);
  boxes[1]->ResetMassData();
  arena.step(300);
  CHECK(std::abs(boxes[1]->GetPosition().y - 1.5) < 1e-6);
}

// From rest: s = 1/2 (g sin - mu g cos) t^2.
TEST_CASE("a block with impulses slides down a slope as the formula says, and stays within friction") {
  for (const double slope : {0.3, 0.5, 0.7}) {
    for (const double over_slope : {0., 0.5, 0.99, 1.01}) {
      ImpulseWorld arena;
      const float friction = float(over_slope * std::tan(slope));
      const b2Rot turn(-float(slope));
      add_polygon(arena.world, box_shape(50, 1), {0, 0}, -float(slope), b2_staticBody).SetFriction(friction);
      b2Fixture& block =
          add_polygon(arena.world, box_shape(0.5f, 0.5f), 1.5f * turn.GetYAxis(), -float(slope));
      block.SetFriction(friction);
      const b2Vec2 from = block.GetBody()->GetPosition();
      arena.step(60);
      const double moved = b2Dot(block.GetBody()->GetPosition() - from, turn.GetXAxis());
      const double acceleration =
          std::max(0., gravity * (std::sin(slope) - double(friction) * std::cos(slope)));
      INFO("slope " << slope << ", friction " << friction);
      CHECK(moved == Approx(0.5 * acceleration).epsilon(1e-3).margin(1e-5));
      CHECK(b2Dot(block.GetBody()->GetLinearVelocity(), turn.GetXAxis()) ==
            Approx(acceleration).epsilon(1e-3).margin(1e-5));
    }
  }
}

// An impact of speed v = sqrt(2 g h) at time v / g; the apex follows after e v / g, at height e^2 h.
TEST_CASE("a box with impulses bounces to the height of its restitution") {
  for (const float restitution : {1.f, 0.5f, 0.f}) {
    ImpulseWorld arena({.locate_impacts = true});
    add_floor(arena.world);
    b2Body& box = add_box(arena.world, {0, 1.5f});
    box.GetFixtureList()->SetRestitution(restitution);
    const double fall = std::sqrt(2 / gravity);
    arena.step(int(std::ceil(60 * fall)) + 1);
    double highest = 0;
    for (int i = 0; i < 60; ++i) {
      const double v = box.GetLinearVelocity().y, y = box.GetPosition().y - 0.5;
      highest = std::max(highest, y + v * std::abs(v) / (2 * gravity));  // of the parabola
      if (v <= 0) break;
      arena.step();
    }
    INFO("restitution " << restitution);
    CHECK(highest == Approx(restitution * restitution).margin(1e-3));
  }
}

TEST_CASE("impulses stop a fast box at a thin floor") {
  ImpulseWorld arena;
  add_polygon(arena.world, box_shape(5, 0.01f), {0, -0.01f}, 0, b2_staticBody);
  b2Body& box = add_polygon(arena.world, box_shape(0.05f, 0.05f), {0, 1}).GetBody()[0];
  box.SetLinearVelocity({0, -100});
  arena.step(10);
  CHECK(box.GetPosition().y == Approx(0.05).margin(1e-5));
}

TEST_CASE("motion in free flight is exact, with user forces, damping and scales of gravity") {
  ImpulseWorld arena;
  b2Body& thrown = add_box(arena.world, {0, 100});
  thrown.SetLinearVelocity({3, 4});
  thrown.SetAngularVelocity(0.5f);
  b2Body& pushed = add_box(arena.world, {10, 100});
  pushed.SetGravityScale(0);
  b2Body& damped = add_box(arena.world, {20, 100});
  damped.SetGravityScale(0);
  damped.SetLinearVelocity({1, 0});
  damped.SetLinearDamping(0.5f);
  for (int i = 0; i < 60; ++i) {
    pushed.ApplyForceToCenter({2, 0}, true);
    pushed.ApplyTorque(1.f / 6, true);
    arena.step();
  }
  const double t = 60 * double(1 / 60.f);
  CHECK(thrown.GetPosition().x == Approx(3 * t).epsilon(1e-6));
  CHECK(thrown.GetPosition().y == Approx(100 + 4 * t - gravity * t * t / 2).epsilon(1e-6));
  CHECK(thrown.GetAngle() == Approx(0.5 * t).epsilon(1e-6));
  CHECK(pushed.GetPosition().x - 10 == Approx(t * t).epsilon(1e-5));
  CHECK(pushed.GetLinearVelocity().x == Approx(2 * t).epsilon(1e-6));
  CHECK(pushed.GetAngularVelocity() == Approx(t).epsilon(1e-5));
  CHECK(damped.GetLinearVelocity().x == Approx(std::pow(1 + 0.5 / 60, -60)).epsilon(1e-5));
}

TEST_CASE("impulse mode detects bodies created, moved, changed and destroyed") {
  ImpulseWorld arena;
  add_floor(arena.world);
  b2Body& first = add_box(arena.world, {0, 0.5f});
  arena.step(30);
  b2Body& second = add_box(arena.world, {0, 1.5f});
  arena.step(30);
  CHECK(second.GetPosition().y == Approx(1.5).margin(1e-6));
  first.SetTransform({5, 0.5f}, 0);
  arena.step(60);
  CHECK(first.GetPosition().x == Approx(5).margin(1e-6));
  CHECK(second.GetPosition().y == Approx(0.5).margin(1e-5));
  first.SetTransform({0, 1.5f}, 0);
  arena.step(60);
  CHECK(first.GetPosition().y == Approx(1.5).margin(1e-5));
  arena.world.DestroyBody(&second);
  arena.step(60);
  CHECK(first.GetPosition().y == Approx(0.5).margin(1e-5));
  b2Fixture& old = *first.GetFixtureList();
  const b2PolygonShape taller = box_shape(0.5f, 1);
  b2Fixture& grown = *first.CreateFixture(&taller, 1);
  first.DestroyFixture(&old);
  first.SetTransform({5, 1}, 0);
  arena.step(60);
  CHECK(arena.impulses.block_of(grown) != 0);
  CHECK(first.GetPosition().y == Approx(1).margin(1e-5));
  grown.SetSensor(true);
  arena.step(30);
  CHECK(arena.impulses.block_of(grown) == 0);
  CHECK(first.GetPosition().y < 0.5f);
}

TEST_CASE("a kinematic block carries a box by impulses") {
  ImpulseWorld arena;
  b2Body& belt = *add_polygon(arena.world, box_shape(10, 0.5f), {0, -0.5f}, 0, b2_kinematicBody).GetBody();
  belt.SetLinearVelocity({0.5f, 0.25f});
  const b2Body& box = add_box(arena.world, {0, 0.5f});
  arena.step(120);
  CHECK(box.GetLinearVelocity().x == Approx(0.5).epsilon(1e-5));
  CHECK(box.GetLinearVelocity().y == Approx(0.25).epsilon(1e-5));
  CHECK(box.GetPosition().y - belt.GetPosition().y == Approx(1).epsilon(1e-5));
}

// The body of the hinge is also of the mirror: it has no other polygon to leave out.
TEST_CASE("a joint holds a box that swings, with impulses") {
  ImpulseWorld arena;
  const b2BodyDef def;
  b2Body& anchor = *arena.world.CreateBody(&def);
  b2Body& bob = add_box(arena.world, {0, -3});
  add_polygon(arena.world, box_shape(0.5f, 5), {2.5f, -3}, 0, b2_staticBody);
  bob.SetLinearVelocity({6, 0});
  b2RevoluteJointDef hinge;
  hinge.Initialize(&anchor, &bob, {0, 0});
  arena.world.CreateJoint(&hinge);
  float farthest = 0;
  for (int i = 0; i < 120; ++i) {
    arena.step();
    farthest = std::max(farthest, bob.GetPosition().x);
    CHECK(bob.GetPosition().Length() == Approx(3).margin(b2_linearSlop));
  }
  CHECK(arena.impulses.block_of(*bob.GetFixtureList()) != 0);
  CHECK(farthest > 1.2f);
  CHECK(farthest < 1.6f);
}

// On a hinged plank, on an edge, under a ball: the mirror and Box2D share the load.
TEST_CASE("boxes with impulses rest on a plank with a joint and on an edge, and bear a ball") {
  ImpulseWorld arena;
  b2Body& floor = add_edge_floor(arena.world);
  b2Body& plank = *add_polygon(arena.world, box_shape(3, 0.25f), {0, 1}).GetBody();
  b2RevoluteJointDef hinge;
  hinge.Initialize(&floor, &plank, {0, 1});
  arena.world.CreateJoint(&hinge);
  std::vector<b2Body*> pair = {&add_box(arena.world, {-2, 1.75f}), &add_box(arena.world, {2, 1.75f})};
  const std::vector<b2Body*> stack = add_flush_stack(arena.world, 5, 10);
  b2BodyDef round;
  round.type = b2_dynamicBody;
  round.position = {10, 5.5f};
  round.angularDamping = 1;
  b2CircleShape circle;
  circle.m_radius = 0.5f;
  b2Body& ball = *arena.world.CreateBody(&round);
  ball.CreateFixture(&circle, 1);
  arena.step(300);
  for (const b2Body* box : pair) {
    CHECK(std::abs(plank.GetAngle()) < 1e-2);
    CHECK(std::abs(box->GetPosition().y - 1.75) < 1e-2);
    CHECK(box->GetLinearVelocity().Length() < 1e-2);
  }
  for (std::size_t i = 0; i < stack.size(); ++i) {
    CHECK(std::abs(stack[i]->GetPosition().y - 0.5 - double(i)) < 2e-2);
    CHECK(stack[i]->GetLinearVelocity().Length() < 1e-2);
  }
  CHECK(std::abs(ball.GetPosition().y - 5.5) < 3e-2);
}

TEST_CASE("fixtures that must not collide do not, and compound bodies stay with Box2D's solver") {
  ImpulseWorld arena;
  add_floor(arena.world);
  b2Body& below = add_box(arena.world, {0, 0.5f});
  b2Body& ghost = add_box(arena.world, {0, 3});
  b2Filter apart;
  apart.groupIndex = -1;
  below.GetFixtureList()->SetFilterData(apart);
  ghost.GetFixtureList()->SetFilterData(apart);
  b2Body& twin = add_box(arena.world, {5, 0.6f});
  const b2PolygonShape second = [] {
    b2PolygonShape shape;
    shape.SetAsBox(0.5f, 0.5f, {1, 0}, 0);
    return shape;
  }();
  twin.CreateFixture(&second, 1);
  b2Body& upright = add_box(arena.world, {-5, 0.6f}, 0.2f);
  upright.SetFixedRotation(true);
  arena.step(120);
  CHECK(ghost.GetPosition().y == Approx(0.5).margin(0.03));
  CHECK(below.GetPosition().y == Approx(0.5).margin(0.03));
  CHECK(arena.impulses.block_of(*twin.GetFixtureList()) == 0);
  CHECK(twin.GetPosition().y == Approx(0.5).margin(0.03));
  CHECK(upright.GetAngle() == 0.2f);
  CHECK(arena.impulses.block_of(*upright.GetFixtureList()) == 0);
  CHECK(upright.GetPosition().y > 0.5f);
}

TEST_CASE("a fixture that is left to Box2D rests on its skin, and a listener may let a box through") {
  b2Fixture* left = nullptr;
  Options options;
  options.geometry_of = [&](b2Fixture& fixture) { return FixtureGeometry{&fixture == left, nullptr}; };
  ImpulseWorld arena({}, options);
  struct LetThrough : b2ContactListener {
    void PreSolve(b2Contact* contact, const b2Manifold*) override {
      if (contact->GetFixtureA() == through || contact->GetFixtureB() == through) contact->SetEnabled(false);
    }
    b2Fixture* through = nullptr;
  } listener;
  arena.world.SetContactListener(&listener);
  add_floor(arena.world);
  left = &add_polygon(arena.world, box_shape(0.5f, 0.5f), {0, 0.6f});
  b2Body& falling = add_box(arena.world, {5, 0.51f});
  listener.through = falling.GetFixtureList();
  arena.step(60);
  CHECK(arena.impulses.block_of(*left) == 0);
  CHECK(left->GetBody()->GetPosition().y > 0.505f);
  CHECK(falling.GetPosition().y < 0);
  CHECK(arena.world.GetContactManager().m_contactListener == &listener);
}

TEST_CASE("force mode refuses a law without springs") {
  b2World world({0, -10});
  NarrowPhase narrow_phase(world);
  hs_law_def law = law_of(1e5, 1);
  law.stiffness_kind = HS_STIFFNESS_NONE;
  CHECK_THROWS_AS(halfspace::box2d::ForceMode(narrow_phase, law), std::invalid_argument);
}

TEST_CASE("impulse mode refuses what it cannot do") {
  b2World world({0, -10});
  NarrowPhase narrow_phase(world);
  CHECK_THROWS_AS(ImpulseMode(narrow_phase, {.max_iterations = 0}), std::invalid_argument);
  CHECK_THROWS_AS(ImpulseMode(narrow_phase, {.tolerance = -1}), std::invalid_argument);
  ImpulseMode impulses(narrow_phase);
  CHECK_THROWS_AS(ImpulseMode(narrow_phase), std::logic_error);
  CHECK_THROWS_AS(halfspace::box2d::ForceMode(narrow_phase, law_of(1e5, 1)), std::logic_error);
  add_floor(world);
  b2Body& box = add_box(world, {0, 1});
  CHECK_THROWS_AS(impulses.step(-1, 8, 3), std::invalid_argument);
  CHECK_THROWS_AS(impulses.step(std::numeric_limits<float>::quiet_NaN(), 8, 3), std::invalid_argument);
  box.GetFixtureList()->SetRestitution(2);
  CHECK_THROWS_AS(impulses.step(1 / 60.f, 8, 3), std::invalid_argument);
  CHECK(box.GetPosition().y == 1);
  box.GetFixtureList()->SetRestitution(0);
  world.SetSubStepping(true);
  CHECK_THROWS_AS(impulses.step(1 / 60.f, 8, 3), std::logic_error);
  world.SetSubStepping(false);
  CHECK_NOTHROW(impulses.step(0, 8, 3));
  CHECK(box.GetPosition().y == 1);
  for (int i = 0; i < 60; ++i) impulses.step(1 / 60.f, 8, 3);
  CHECK(box.GetPosition().y == Approx(0.5).margin(1e-6));
}

TEST_CASE("a body that has gone to infinity does not stop impulses") {
  ImpulseWorld arena;
  add_floor(arena.world);
  b2Body& lost = add_box(arena.world, {5, 0.5f});
  const b2Body& box = add_box(arena.world, {0, 0.5f});
  arena.step(10);
  lost.SetLinearVelocity({INFINITY, 0});
  CHECK_NOTHROW(arena.step(10));
  CHECK(box.GetPosition().y == Approx(0.5).margin(1e-6));
}

}  // namespace halfspace_test
