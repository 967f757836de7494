// Contact forces of the library in Box2D worlds, against closed forms and against Box2D's own solver.

#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <vector>

#include "catch.h"
#include "force_scenes.h"

namespace halfspace_test {
namespace {

using halfspace::box2d::ForceMode;
using halfspace::box2d::Options;

hs_contact only_contact_of(const ForceWorld& arena) {
  hs_contact contact{};
  std::int64_t count = 0;
  REQUIRE(hs_world_get_contacts(arena.forces->world(), &contact, 1, &count) == HS_OK);
  REQUIRE(count == 1);
  return contact;
}

b2Body& add_box(b2World& world, b2Vec2 at, float angle = 0, b2BodyType type = b2_dynamicBody) {
  return *add_polygon(world, box_shape(0.5f, 0.5f), at, angle, type).GetBody();
}

void add_floor(b2World& world, b2Vec2 at = {0, 0}) {
  add_polygon(world, box_shape(20, 1), at + b2Vec2(0, -1), 0, b2_staticBody);
}

/// Gives out what was freed last first, as allocators do, but for sanitizers'.
class LastFreedFirst {
 public:
  ~LastFreedFirst() {
    for (auto& [bytes, pieces] : freed_) {
      for (void* memory : pieces) std::free(memory);
    }
  }

  hs_context_def definition() {
    hs_context_def def;
    REQUIRE(hs_context_def_init(&def, sizeof def) == HS_OK);
    def.allocate = [](std::size_t bytes, std::size_t, void* user) {
      std::vector<void*>& pieces = static_cast<LastFreedFirst*>(user)->freed_[bytes];
      if (pieces.empty()) return std::aligned_alloc(64, (bytes + 63) / 64 * 64);
      void* memory = pieces.back();
      pieces.pop_back();
      return memory;
    };
    def.release = [](void* memory, std::size_t bytes, std::size_t, void* user) {
      static_cast<LastFreedFirst*>(user)->freed_[bytes].push_back(memory);
    };
    def.user = this;
    return def;
  }

 private:
  std::map<std::size_t, std::vector<void*>> freed_;
};

double distance(const b2Body& a, const b2Body& b) { return (a.GetPosition() - b.GetPosition()).Length(); }

}  // namespace

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
  const double by_box2d = creep_of_stack({}, 3, slope, friction);
  const double by_forces = creep_of_stack(law_of(1e5, 1), 3, slope, friction);
  INFO("Box2D " << by_box2d << " m, forces " << by_forces << " m");
  CHECK(by_box2d > 1e-3);
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
  CHECK_THROWS_AS(arena.forces->step(1 / 60.f, enough - 1, 8, 3), std::invalid_argument);
  CHECK_NOTHROW(arena.forces->step(1 / 60.f, enough, 8, 3));
  CHECK(arena.forces->sub_steps_for(1 / 60.f) >= 2 * (enough - 1));
}

TEST_CASE("a law that the library refuses, and a second force mode, are refused") {
  ForceWorld arena(law_of(1e5, 0.1));
  CHECK_THROWS_AS(ForceMode(*arena.narrow_phase, law_of(1e5, 0.1)), std::logic_error);
  arena.forces.reset();
  CHECK_THROWS_AS(ForceMode(*arena.narrow_phase, law_of(-1, 0)), std::invalid_argument);
  CHECK_NOTHROW(ForceMode(*arena.narrow_phase, law_of(1e5, 0.1)));
}

// Box2D gives the memory of what was destroyed to what is made next.
TEST_CASE("a body made in the place of another has no shear of before") {
  ForceWorld arena(law_of(1e5, 0.05), {2, -float(gravity)});
  add_floor(arena.world);
  b2Body& before = add_box(arena.world, {0, 0.5f});
  arena.step(300);
  CHECK(std::abs(only_contact_of(arena).shear_force[0]) > 1);
  arena.world.DestroyBody(&before);
  arena.world.SetGravity({0, -float(gravity)});
  const b2Body& after = add_box(arena.world, {5, 0.4999f});  // as deep as it rests
  REQUIRE(&after == &before);                                // else this tests nothing
  arena.step();
  CHECK(std::abs(after.GetLinearVelocity().x) < 1e-5f);
}

TEST_CASE("a body that has gone to infinity does not stop the others") {
  ForceWorld arena(law_of(1e5, 0.5));
  add_floor(arena.world);
  b2Body& lost = add_box(arena.world, {5, 0.5f});
  const b2Body& box = add_box(arena.world, {0, 0.5f});
  arena.step(60);
  lost.ApplyForceToCenter({INFINITY, 0}, true);
  CHECK_NOTHROW(arena.step(60));
  CHECK(box.GetPosition().y == Approx(0.5 - gravity / 1e5).epsilon(1e-6));
}

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

namespace {

class Witness : public b2ContactListener {
 public:
  void BeginContact(b2Contact*) override { ++begun; }
  void EndContact(b2Contact*) override { ++ended; }
  void PreSolve(b2Contact* contact, const b2Manifold*) override {
    ++asked;
    if (lets_through) contact->SetEnabled(false);
  }
  void PostSolve(b2Contact*, const b2ContactImpulse*) override { ++solved; }

  bool lets_through = false;
  int begun = 0, ended = 0, asked = 0, solved = 0;
};

}  // namespace

TEST_CASE("the host's listener sees contacts begin and end, and may let them through") {
  for (const bool lets_through : {false, true}) {
    ForceWorld arena(law_of(1e5, 0));
    Witness witness;
    witness.lets_through = lets_through;
    arena.world.SetContactListener(&witness);
    add_floor(arena.world);
    const b2Body& box = add_box(arena.world, {0, 2});
    arena.step(90);  // an undamped bounce takes 2 sqrt(2 1.5 / 10) s
    CHECK(arena.world.GetContactManager().m_contactListener == &witness);
    CHECK(witness.begun == 1);
    CHECK(witness.ended == 1);
    CHECK(witness.asked > 1);
    CHECK(witness.solved == 0);
    CHECK((box.GetPosition().y > 0.5f) == !lets_through);
  }
}

TEST_CASE("at its end the contacts are Box2D's again, at its beginning nobody is woken") {
  ForceWorld arena(law_of(1e6, 0.5));
  add_stack(arena.world, 3);
  arena.step(30);
  Witness witness;
  arena.world.SetContactListener(&witness);
  arena.forces.reset();
  step(arena.world, 60);
  CHECK(witness.solved >= 3 * 30);  // half a second, after which the stack may fall asleep
  CHECK(witness.ended == 0);
  // Skins of Box2D overlap by what it allows them to: boxes lie up to 2 cm apart.
  for (b2Body* body = arena.world.GetBodyList(); body; body = body->GetNext()) {
    if (body->GetType() == b2_staticBody) continue;
    const double above = body->GetPosition().y - std::floor(body->GetPosition().y);
    CHECK(above > 0.5);
    CHECK(above < 0.56);
  }
  step(arena.world, 240);
  const auto is_asleep = [&] {
    const b2Body* body = arena.world.GetBodyList();
    while (body && (body->GetType() == b2_staticBody || !body->IsAwake())) body = body->GetNext();
    return body == nullptr;
  };
  REQUIRE(is_asleep());
  const std::vector<float> asleep = state_of(arena.world);
  arena.forces.emplace(*arena.narrow_phase, law_of(1e6, 0.5));
  arena.step(10);
  CHECK(is_asleep());
  arena.forces.reset();
  for (const b2Contact* contact : contacts_of(arena.world)) CHECK(contact->IsEnabled());
  step(arena.world, 10);
  CHECK(is_asleep());
  CHECK(state_of(arena.world) == asleep);
}

TEST_CASE("a stack falls asleep, and what moves on it wakes it") {
  ForceWorld arena(law_of(1e5, 0.5));
  add_stack(arena.world, 3);
  arena.step(240);
  b2Body& top = *arena.world.GetBodyList();
  const b2Body& middle = *top.GetNext();
  REQUIRE(!top.IsAwake());
  REQUIRE(!middle.IsAwake());
  const std::vector<float> asleep = state_of(arena.world);
  arena.step(60);
  CHECK(state_of(arena.world) == asleep);
  const b2Body& falling = add_box(arena.world, {0, top.GetPosition().y + 2});
  bool has_woken = false;
  for (int i = 0; i < 60; ++i) {
    arena.step();
    has_woken = has_woken || top.IsAwake();
  }
  CHECK(has_woken);
  arena.step(240);
  CHECK(!falling.IsAwake());
  CHECK(falling.GetPosition().y == Approx(3.5).margin(1e-2));
  REQUIRE(!middle.IsAwake());
  top.SetLinearVelocity({0.5f, 0});
  arena.step();
  CHECK(middle.IsAwake());
}

// The joint of a box that lies on another holds it, and the boxes do not pass each other.
TEST_CASE("joints hold as ever") {
  ForceWorld arena(law_of(1e6, 0.5));
  add_floor(arena.world);
  b2Body& wall = *add_polygon(arena.world, box_shape(0.5f, 5), {3, 5}, 0, b2_staticBody).GetBody();
  b2Body& anchor = add_box(arena.world, {0, 6}, 0, b2_staticBody);
  b2Body& bob = add_box(arena.world, {0, 3});
  bob.SetLinearVelocity({6, 0});
  b2RevoluteJointDef hinge;
  hinge.Initialize(&anchor, &bob, {0, 6});
  b2Joint& joint = *arena.world.CreateJoint(&hinge);
  float farthest = 0;
  for (int i = 0; i < 120; ++i) {
    arena.step();
    farthest = std::max(farthest, bob.GetPosition().x);
    CHECK((joint.GetAnchorA() - joint.GetAnchorB()).Length() < b2_linearSlop);
    CHECK(distance(anchor, bob) == Approx(3).margin(b2_linearSlop));
  }
  CHECK(farthest > 1.7f);
  CHECK(farthest < wall.GetPosition().x - 1);
}

TEST_CASE("a kinematic block carries what lies on it") {
  ForceWorld arena(law_of(1e5, 0.5));
  b2Body& belt = *add_polygon(arena.world, box_shape(10, 0.5f), {0, -0.5f}, 0, b2_kinematicBody).GetBody();
  belt.SetLinearVelocity({0.5f, 0.25f});
  const b2Body& box = add_box(arena.world, {0, 0.5f});
  arena.step(120);
  CHECK(box.GetLinearVelocity().x == Approx(0.5).epsilon(1e-4));
  CHECK(box.GetLinearVelocity().y == Approx(0.25).epsilon(1e-4));
  CHECK(belt.GetPosition().x == Approx(1).epsilon(1e-5));
}

TEST_CASE("bodies and fixtures made, changed and destroyed are found") {
  ForceWorld arena(law_of(1e5, 0.5));
  add_floor(arena.world);
  b2Body& first = add_box(arena.world, {0, 0.5f});
  arena.step(60);
  b2Body& second = add_box(arena.world, {0, 1.5f});
  arena.step(60);
  CHECK(second.GetPosition().y == Approx(1.5).margin(1e-3));
  arena.world.DestroyBody(&first);
  arena.step(60);
  CHECK(second.GetPosition().y == Approx(0.5).margin(1e-3));
  b2Fixture& old = *second.GetFixtureList();
  const hs_block block = arena.forces->block_of(old);
  CHECK(block != 0);
  const b2PolygonShape taller = box_shape(0.5f, 1);
  b2Fixture& grown = *second.CreateFixture(&taller, 1);
  second.DestroyFixture(&old);
  second.SetTransform({5, 1}, 0);
  arena.step(60);
  CHECK(arena.forces->block_of(grown) != block);
  CHECK(second.GetPosition().x == Approx(5).margin(1e-4));
  CHECK(second.GetPosition().y == Approx(1).margin(1e-3));
  grown.SetSensor(true);
  arena.step(30);
  CHECK(arena.forces->block_of(grown) == 0);
  CHECK(second.GetPosition().y < 0.5f);
}

TEST_CASE("a polygon attached to a new body is not that of the body before") {
  LastFreedFirst memory;
  const hs_context_def def = memory.definition();
  const Context context = make_context(&def);
  const hs_shape* attached = nullptr;
  ForceWorld arena(std::nullopt);
  Options options;
  options.geometry_of = [&](b2Fixture& fixture) {
    const bool is_floor = fixture.GetBody()->GetType() == b2_staticBody;
    return FixtureGeometry{false, is_floor ? nullptr : attached};
  };
  arena.narrow_phase.emplace(arena.world, options);
  arena.forces.emplace(*arena.narrow_phase, law_of(1e5, 0.5));
  add_floor(arena.world);
  const auto add_body = [&](float y) -> b2Body& {
    return *add_polygon(arena.world, halfspace::box2d::box_around(*attached), {0, y}).GetBody();
  };
  Shape tall = make_shape(context.get(), {{-0.5, -1}, {0.5, -1}, {0.5, 1}, {-0.5, 1}});
  attached = tall.get();
  b2Body& before = add_body(1);
  arena.step(60);
  CHECK(before.GetPosition().y == Approx(1).epsilon(1e-3));
  arena.world.DestroyBody(&before);
  tall.reset();
  const Shape flat = make_shape(context.get(), {{-1, -0.25}, {1, -0.25}, {1, 0.25}, {-1, 0.25}});
  REQUIRE(flat.get() == attached);  // else this tests nothing
  const b2Body& after = add_body(0.25f);
  arena.step(60);
  CHECK(after.GetPosition().y == Approx(0.25).epsilon(1e-3));
}

TEST_CASE("a polygon of many vertices rests on its own side, with its own mass") {
  const int count = 40;
  const Context context = make_context();
  Points vertices;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * halfspace_benchmark::pi * (i + 0.5) / count - halfspace_benchmark::pi / 2;
    vertices.push_back({std::cos(angle), std::sin(angle)});
  }
  const Shape polygon = make_shape(context.get(), vertices);
  b2World world({0, -float(gravity)});
  halfspace::box2d::Options options;
  options.geometry_of = [&](b2Fixture& fixture) {
    const bool is_round = fixture.GetBody()->GetType() == b2_dynamicBody;
    return FixtureGeometry{false, is_round ? polygon.get() : nullptr};
  };
  NarrowPhase narrow_phase(world, options);
  ForceMode forces(narrow_phase, law_of(1e5, 0.5));
  add_floor(world);
  const b2PolygonShape box = halfspace::box2d::box_around(*polygon);
  b2Body& body = *add_polygon(world, box, {0, 1}).GetBody();
  const b2MassData mass = halfspace::box2d::mass_of(*polygon, 1);
  body.SetMassData(&mass);
  for (int i = 0; i < 180; ++i) forces.step(1 / 60.f, forces.sub_steps_for(1 / 60.f), 8, 3);
  hs_block_state state{};
  REQUIRE(hs_world_get_block_state(forces.world(), forces.block_of(*body.GetFixtureList()), &state) == HS_OK);
  CHECK(state.mass == Approx(body.GetMass()).epsilon(1e-6));
  const double apothem = std::cos(halfspace_benchmark::pi / count);
  CHECK(body.GetPosition().y == Approx(apothem - body.GetMass() * gravity / 1e5).margin(1e-6));
}

TEST_CASE("fixtures that are left to Box2D, and circles, stay with its solver") {
  b2World world({0, -float(gravity)});
  b2Fixture* left = nullptr;
  halfspace::box2d::Options options;
  options.geometry_of = [&](b2Fixture& fixture) { return FixtureGeometry{&fixture == left, nullptr}; };
  NarrowPhase narrow_phase(world, options);
  ForceMode forces(narrow_phase, law_of(1e5, 0.5));
  add_floor(world);
  left = &add_polygon(world, box_shape(0.5f, 0.5f), {0, 0.52f});
  const b2Body& box = add_box(world, {5, 0.52f});
  b2BodyDef round;
  round.type = b2_dynamicBody;
  round.position = {10, 0.52f};
  b2CircleShape circle;
  circle.m_radius = 0.5f;
  b2Body& ball = *world.CreateBody(&round);
  ball.CreateFixture(&circle, 1);
  for (int i = 0; i < 120; ++i) forces.step(1 / 60.f, forces.sub_steps_for(1 / 60.f), 8, 3);
  CHECK(left->GetBody()->GetPosition().y > 0.51f);
  CHECK(box.GetPosition().y < 0.5f);
  CHECK(ball.GetPosition().y > 0.5f);
}

}  // namespace halfspace_test
