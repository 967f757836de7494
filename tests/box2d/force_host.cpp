// Force mode and its host: listeners, what is made, changed and destroyed, sleep, joints, attached polygons.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <vector>

#include "catch.h"
#include "force_arena.h"

namespace halfspace_test {
namespace {

using halfspace::box2d::ForceMode;
using halfspace::box2d::Options;

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

class PairCache : public b2ContactListener {
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

/// A box of 1 kg, put so high above a floor, that bears 10 N and is pushed along it by 1 N, after so many
/// frames.
struct PushedBox : ForceWorld {
  explicit PushedBox(int frames, float height = 0) : ForceWorld(law_of(1e5, 0.5), {1, -float(gravity)}) {
    world.SetAllowSleeping(false);
    add_floor(world);
    box = &add_box(world, {0, 0.5f + height});
    step(frames);
  }

  b2Body* box;
};

}  // namespace

// Box2D gives the memory of what was destroyed to what is made next. Of another density it is another block
// of the same polygon.
TEST_CASE("a body made in the place of another has no shear of before") {
  for (const float density : {1.f, 2.f}) {
    ForceWorld arena(law_of(1e5, 0.05), {2, -float(gravity)});
    add_floor(arena.world);
    b2Body& before = add_box(arena.world, {0, 0.5f});
    arena.step(300);
    CHECK(std::abs(only_contact_of(arena).shear_force[0]) > 1);
    arena.world.DestroyBody(&before);
    arena.world.SetGravity({0, -float(gravity)});
    b2Body& after = add_box(arena.world, {5, 0.5f - density * 1e-4f});  // as deep as it rests
    REQUIRE(&after == &before);                                         // else this tests nothing
    after.GetFixtureList()->SetDensity(density);
    after.ResetMassData();
    arena.step();
    CHECK(std::abs(after.GetLinearVelocity().x) < 1e-5f);
  }
}

// Box2D ends the pairs of a body that becomes another kind and begins them anew, as refresh() does those of a
// fixture. With no shear, as undamped springs swing, the box would gain 1 m/s2 sqrt(m / k) = 3e-3 m/s; one
// sub-step without a pair gives it 1e-4 m/s.
TEST_CASE("a contact that begins anew under a box at rest carries its weight from the beginning") {
  for (const bool becomes_another_kind : {true, false}) {
    PushedBox arena(300);
    b2Body& box = *arena.box;
    double fastest = 0;
    if (becomes_another_kind) {
      box.SetType(b2_staticBody);
      box.SetType(b2_dynamicBody);
    } else {
      arena.narrow_phase->refresh(*box.GetFixtureList());
    }
    const int n = arena.sub_steps();
    for (int i = 0; i < 2 * n; ++i) {
      arena.forces->step(1 / 60.f / float(n), 1, 8, 3);
      fastest = std::max(fastest, std::abs(double(box.GetLinearVelocity().x)));
    }
    CHECK(fastest < 3e-4);
  }
}

// The first pair begins before the boxes touch, as what falls does, and is no longer new when others begin.
TEST_CASE("a pair that begins leaves others their shear") {
  PushedBox arena(300, 1e-3f);
  const double before = only_contact_of(arena).shear_force[0];
  CHECK(std::abs(before) > 0.9);
  add_box(arena.world, {5, 0.51f});
  arena.step();
  CHECK(only_contact_of(arena).shear_force[0] == Approx(before).epsilon(1e-6));
}

// By then the swing has died down to less than floats tell, and once it slides what friction holds is known
// to their rounding; 1e-4 is for the rocking of the box, which 0.5 N tilts by 1e-5.
TEST_CASE("a friction that changes leaves contacts the shear that it can hold") {
  for (const bool is_of_floor : {false, true}) {
    PushedBox arena(180);
    b2Body& box = *arena.box;
    b2Fixture& changed = *(is_of_floor ? box.GetContactList()->other : &box)->GetFixtureList();
    const b2Vec2 at = box.GetPosition();
    const auto set_friction = [&](float mixed) { changed.SetFriction(mixed * mixed / 0.2f); };
    INFO("of the floor: " << is_of_floor);
    for (const float holds : {0.5f, 0.11f}) {
      set_friction(holds);
      arena.step();
      CHECK(only_contact_of(arena).shear_force[0] == Approx(-1).epsilon(1e-6));
      CHECK((box.GetPosition() - at).Length() < 1e-6);
    }
    set_friction(0.05f);
    arena.step();
    CHECK(only_contact_of(arena).shear_force[0] == Approx(-0.5).epsilon(1e-6));
    CHECK(box.GetLinearVelocity().x == Approx(0.5 / 60).epsilon(0.0001));
  }
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

TEST_CASE("the host's listener sees contacts begin and end, and may let them through") {
  for (const bool lets_through : {false, true}) {
    ForceWorld arena(law_of(1e5, 0));
    PairCache witness;
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
  PairCache witness;
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
