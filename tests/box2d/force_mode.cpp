// Contact forces of the library in Box2D worlds, against closed forms and against Box2D's own solver.

#include <cmath>
#include <stdexcept>
#include <vector>

#include "catch.h"
#include "force_arena.h"

namespace halfspace_test {

using halfspace::box2d::ForceMode;

// Damped, so that it comes to rest. The impulses of a sub-step are floats: a few roundings of 2^-24 of the
// weight.
TEST_CASE("a block rests with the overlap that its weight needs, near and far") {
  for (const float away : {0.f, 10.f, 1000.f}) {
    for (const auto kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA}) {
      hs_law_def law = law_of(1e5, 0.5);
      law.stiffness_kind = kind;
      ForceWorld arena(law);
      add_floor(arena.world, {away, away});
      b2Body& box = *add_polygon(arena.world, box_shape(1, 0.5f), {away, away + 0.5f}).GetBody();
      arena.step(180);
      const double weight = 2 * gravity;
      const double overlap = weight / law.normal_stiffness / (kind == HS_STIFFNESS_PER_AREA ? 2 : 1);
      INFO(away << " m away, kind " << kind);
      CHECK(-only_contact_of(arena).gap == Approx(overlap).epsilon(1e-6));
      CHECK(only_contact_of(arena).normal_force == Approx(weight).epsilon(1e-6));
      CHECK(std::abs(box.GetLinearVelocity().y) < 1e-6);
    }
  }
}

// The contact plane tilts with the block by its overlap over its size, 2 W / (K w) at most, and so do weight
// and friction to it; friction takes up mu times the momentum that is left in the normal direction, which is
// less than that of the overlap; and positions of 5 m and their times are floats.
TEST_CASE("A4.1 a block slides down a slope as the formula says") {
  const double stiffness = 1e6, friction = 0.2;
  for (const double slope : {0.3, 0.5, 0.8}) {
    const Slide slide = slide_down(law_of(stiffness, 1), slope, friction);
    const double tilt = 2 * gravity / stiffness;
    INFO("slope " << slope << ": " << slide.distance << " m, expected " << slide.expected);
    CHECK(std::abs(slide.distance - slide.expected) <
          0.5 * gravity * tilt + friction * gravity / stiffness + 5 * 0x1p-22);
  }
}

// Gravity is turned slowly, so that no spring is set swinging. Its components and the friction are floats, of
// which the slope at the angle of friction is found with an error of some 2^-22: 5.5 s of that acceleration.
TEST_CASE("a block does not creep down a slope as steep as its friction angle") {
  const double slope = 0.5;
  ForceWorld arena(law_of(1e5, 1));
  arena.world.SetAllowSleeping(false);
  const float friction = float(std::tan(slope));
  add_polygon(arena.world, box_shape(50, 1), {0, -1}, 0, b2_staticBody).SetFriction(friction);
  b2Fixture& block = add_polygon(arena.world, box_shape(0.5f, 0.5f), {0, 0.5f});
  block.SetFriction(friction);
  for (int i = 0; i <= 240; ++i) {
    const double t = i / 240., angle = slope * t * t * t * (10 - 15 * t + 6 * t * t);
    arena.world.SetGravity({float(gravity * std::sin(angle)), -float(gravity * std::cos(angle))});
    arena.step();
  }
  arena.step(30);
  const float from = block.GetBody()->GetPosition().x;
  arena.step(300);
  CHECK(std::abs(block.GetBody()->GetPosition().x - from) < 0.5 * gravity * 0x1p-22 * 5.5 * 5.5);
}

TEST_CASE("a stack on a slope a little below its friction angle creeps less than a tenth of Box2D's") {
  const float slope = 0.5f, friction = 1.01f * std::tan(slope);
  const double by_box2d = creep_let_go({}, 3, slope, friction);
  const double by_forces = creep_let_go(law_of(1e5, 1), 3, slope, friction);
  INFO("Box2D " << by_box2d << " m, forces " << by_forces << " m");
  CHECK(by_box2d > 1e-3);
  CHECK(std::abs(by_forces) < 0.1 * by_box2d);
}

// The slope and the tangent are floats: as above, of 5 s.
TEST_CASE("a block that has settled does not creep when the friction falls to the slope") {
  for (const float slope : {0.1f, 0.3f, 0.5f}) {
    INFO("slope " << slope);
    CHECK(std::abs(creep_settled(law_of(1e5, 1), 1, slope, std::tan(slope))) <
          0.5 * gravity * 0x1p-22 * 5 * 5);
  }
}

// Springs give way, so that the boxes lean downhill, and all but the lowest lie on steeper slopes than that
// of the floor: creep falls with the stiffness. Box2D's comes of its iterations.
TEST_CASE(
    "a stack that has settled creeps less than a tenth of Box2D's when the friction falls to the slope") {
  const float slope = 0.5f, friction = std::tan(slope);
  const double by_box2d = creep_settled({}, 5, slope, friction);
  const double by_forces = creep_settled(law_of(5e5, 1), 5, slope, friction);
  INFO("Box2D " << by_box2d << " m, forces " << by_forces << " m");
  CHECK(by_box2d > 0.1);
  CHECK(std::abs(by_forces) < 0.1 * by_box2d);
}

// Undamped. The first and the last force come up to a sub-step h late, of an overlap of up to v h: of the
// energy 1/2 m v^2 a share of up to (omega h)^2 is missed or made at each, half of that of the velocity.
TEST_CASE("an undamped head-on bounce gives the velocities back") {
  for (const bool are_bullets : {false, true}) {
    const Bounce bounce = bounce_head_on(1e5, 4, are_bullets);
    CHECK(std::abs(bounce.speed - 1) < bounce.omega_h * bounce.omega_h);
  }
}

// 1e-6 m in a sub-step are less than half of the spacing of floats at 1 km, 3e-5 m. Box2D's own position is
// within two spacings of the true one.
TEST_CASE("motion that is lost in floats is not lost") {
  ForceWorld arena(law_of(1e5, 0), {0, 0});
  arena.world.SetAllowSleeping(false);
  b2Body& body = add_box(arena.world, {1000, 0});
  body.SetLinearVelocity({0.01f, 0});
  for (int i = 0; i < 100; ++i) arena.forces->step(0.01f, 100, 8, 3);
  CHECK(body.GetPosition().x - 1000 == Approx(0.01).margin(1000 * 0x1p-22));
  CHECK(body.GetLinearVelocity().x == 0.01f);
}

TEST_CASE("user forces act in all sub-steps, and are cleared as ever") {
  for (const bool are_cleared : {true, false}) {
    ForceWorld arena(law_of(1e5, 0), {0, 0});
    arena.world.SetAutoClearForces(are_cleared);
    b2Body& body = add_box(arena.world, {0, 0});
    body.ApplyForceToCenter({3, 0}, true);
    body.ApplyTorque(0.5f, true);
    arena.step();
    CHECK(body.GetLinearVelocity().x == Approx(3 / 60.).epsilon(1e-5));
    CHECK(body.GetAngularVelocity() == Approx(0.5 * 6 / 60.).epsilon(1e-5));
    CHECK(arena.world.GetAutoClearForces() == are_cleared);
    arena.step();
    CHECK(body.GetLinearVelocity().x == Approx((are_cleared ? 3 : 6) / 60.).epsilon(1e-5));
  }
}

TEST_CASE("sub-steps that are not stable are refused, and nothing has moved") {
  ForceWorld arena(law_of(1e7, 0.1));
  add_floor(arena.world);
  const b2Body& box = add_box(arena.world, {0, 0.5f});
  CHECK_THROWS_AS(arena.forces->step(1 / 60.f, 1, 8, 3), std::invalid_argument);
  CHECK_THROWS_AS(arena.forces->step(1 / 60.f, 0, 8, 3), std::invalid_argument);
  CHECK_THROWS_AS(arena.forces->step(-1, 10, 8, 3), std::invalid_argument);
  CHECK(box.GetPosition().y == 0.5f);
  CHECK(box.GetLinearVelocity().y == 0);
  const double stable = arena.forces->stable_sub_step();
  const int enough = int(std::ceil(1 / 60. / stable));
  CHECK(arena.forces->sub_steps_for(1 / 60.f) >= 2 * (enough - 1));
  CHECK_THROWS_AS(arena.forces->step(1 / 60.f, enough - 1, 8, 3), std::invalid_argument);
  CHECK_NOTHROW(arena.forces->step(1 / 60.f, enough, 8, 3));
}

TEST_CASE("a law that the library refuses, and a second force mode, are refused") {
  ForceWorld arena(law_of(1e5, 0.1));
  CHECK_THROWS_AS(ForceMode(*arena.narrow_phase, law_of(1e5, 0.1)), std::logic_error);
  arena.forces.reset();
  CHECK_THROWS_AS(ForceMode(*arena.narrow_phase, law_of(-1, 0)), std::invalid_argument);
  CHECK_NOTHROW(ForceMode(*arena.narrow_phase, law_of(1e5, 0.1)));
}

// Box2D gives the memory of what was destroyed to what is made next.
TEST_CASE("pairs that filters, joints or one body keep apart take no force") {
  ForceWorld arena(law_of(1e5, 0.1), {0, 0});
  b2Fixture& ghost = add_polygon(arena.world, box_shape(0.5f, 0.5f), {0, 0});
  b2Filter nothing;
  nothing.maskBits = 0;
  ghost.SetFilterData(nothing);
  b2Body& other = add_box(arena.world, {0.3f, 0});
  b2Body& hinged = add_box(arena.world, {10, 0});
  b2Body& next = add_box(arena.world, {10.3f, 0});
  b2RevoluteJointDef hinge;
  hinge.Initialize(&hinged, &next, {10.15f, 0});
  arena.world.CreateJoint(&hinge);
  b2Body& cross = *add_polygon(arena.world, box_shape(2, 0.5f), {20, 0}).GetBody();
  const b2PolygonShape bar = box_shape(0.5f, 2);
  cross.CreateFixture(&bar, 1);
  arena.step(30);
  for (const b2Body* body : {ghost.GetBody(), &other, &hinged, &next, &cross}) {
    CHECK(body->GetLinearVelocity() == b2Vec2(0, 0));
    CHECK(body->GetAngularVelocity() == 0);
  }
}

// Of a body of two boxes that lies on both: each carries its share of the weight.
TEST_CASE("a body of several fixtures rests on them") {
  ForceWorld arena(law_of(1e5, 0.5));
  add_floor(arena.world);
  b2Body& body = *add_polygon(arena.world, box_shape(0.5f, 0.5f), {0, 0.5f}).GetBody();
  b2PolygonShape second;
  second.SetAsBox(0.5f, 0.5f, {3, 0}, 0);
  body.CreateFixture(&second, 1);
  arena.step(180);
  CHECK(body.GetPosition().y == Approx(0.5 - gravity / 1e5).margin(1e-6));
  CHECK(std::abs(body.GetAngle()) < 1e-6);
}

// Undamped, as a dashpot is made for the mass of a block. Only one corner meets the floor, so that it does
// not matter what the rest of the body is cut into; what it slips is the motion of the whole body.
TEST_CASE("a body cut into two fixtures bounces as in one piece") {
  b2Vec2 velocity[2];
  float spin[2];
  for (const bool is_cut : {false, true}) {
    ForceWorld arena(law_of(1e5, 0), {0, 0});
    add_floor(arena.world);
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position = {0, 1.2f};
    def.angle = 0.5f;
    def.linearVelocity = {0.5f, -2};
    def.angularVelocity = 3;
    b2Body& body = *arena.world.CreateBody(&def);
    b2PolygonShape piece = box_shape(1, 0.5f);
    if (is_cut) {
      for (const float side : {-0.5f, 0.5f}) {
        piece.SetAsBox(0.5f, 0.5f, {side, 0}, 0);
        body.CreateFixture(&piece, 1);
      }
    } else {
      body.CreateFixture(&piece, 1);
    }
    for (int i = 0; i < 10; ++i) arena.forces->step(1 / 60.f, 1000, 8, 3);
    velocity[is_cut] = body.GetLinearVelocity();
    spin[is_cut] = body.GetAngularVelocity();
  }
  CHECK(velocity[0].y > 0);
  CHECK(velocity[0].x != Approx(0.5).epsilon(0.1));
  CHECK(velocity[1].x == Approx(velocity[0].x).epsilon(1e-3));
  CHECK(velocity[1].y == Approx(velocity[0].y).epsilon(1e-3));
  CHECK(spin[1] == Approx(spin[0]).epsilon(1e-3));
}

}  // namespace halfspace_test
