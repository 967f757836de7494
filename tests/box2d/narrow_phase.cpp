// The narrow phase in living worlds: what it leaves alone, what it takes over, and what it gives back.

#include <stdexcept>
#include <thread>

#include "catch.h"
#include "world_fixture.h"

namespace halfspace_test {
namespace {

using halfspace::box2d::Options;
using halfspace::box2d::Statistics;

Options left_to_box2d(const bool& left) {
  Options options;
  options.geometry_of = [&left](b2Fixture&) { return FixtureGeometry{left, nullptr}; };
  return options;
}

/// Every touching contact's ids and impulses.
struct SolverPoint {
  const b2Contact* contact;
  std::uint32_t id;
  float impulse;
};
std::vector<SolverPoint> points_of(b2World& world) {
  std::vector<SolverPoint> points;
  for (const b2Contact* c : contacts_of(world)) {
    const b2Manifold& m = *c->GetManifold();
    for (int i = 0; i < m.pointCount; ++i)
      points.push_back({c, m.points[i].id.key, m.points[i].normalImpulse});
  }
  return points;
}

bool have_same_ids(const std::vector<SolverPoint>& one, const std::vector<SolverPoint>& other) {
  return std::equal(
      one.begin(), one.end(), other.begin(), other.end(),
      [](const SolverPoint& p, const SolverPoint& q) { return p.contact == q.contact && p.id == q.id; });
}

class CountingListener : public b2ContactListener {
 public:
  void BeginContact(b2Contact*) override { ++begun; }
  void EndContact(b2Contact*) override { ++ended; }
  int begun = 0;
  int ended = 0;
};

}  // namespace

TEST_CASE("two boxes: one falls on the other and rests on it") {
  b2World world({0, -10});
  const NarrowPhase narrow_phase(world);
  add_stack(world, 2);
  step(world, 200);
  // At rest the skins overlap by the slop that Box2D lets be, and by thrice that at most.
  for (const b2Body* b = world.GetBodyList(); b; b = b->GetNext()) {
    if (b->GetType() != b2_dynamicBody) continue;
    CHECK(b->GetLinearVelocity().Length() < 1e-3f);
    CHECK(std::abs(b->GetAngle()) < 1e-3f);
  }
  const float top = world.GetBodyList()->GetPosition().y;
  CHECK(top > 1.5f + 2 * (2 * b2_polygonRadius - 3 * b2_linearSlop));
  CHECK(top < 1.5f + 2 * (2 * b2_polygonRadius));
  CHECK(narrow_phase.statistics().touching >= 60);  // two pairs, for the half second until they may sleep
  CHECK(narrow_phase.statistics().refused == 0);
}

TEST_CASE("at rest feature ids stay, and impulses are carried from step to step") {
  b2World world({0, -10});
  world.SetAllowSleeping(false);
  const NarrowPhase narrow_phase(world);
  add_stack(world, 10);
  step(world, 300);
  const std::vector<SolverPoint> first = points_of(world);
  CHECK(first.size() == 20);
  for (int i = 0; i < 100; ++i) {
    step(world);
    REQUIRE(have_same_ids(points_of(world), first));
  }
  // The lowest pair carries ten boxes of 1 kg, which eight iterations from nothing would not reach.
  double lowest = 0;
  for (const SolverPoint& p : points_of(world)) lowest = std::max(lowest, double(p.impulse));
  CHECK(2 * lowest == Approx(10 * 10 / 60.).epsilon(0.05));
}

TEST_CASE("a narrow phase that leaves everything to Box2D changes no bit") {
  const bool left = true;
  b2World sample({0, -10}), adapted({0, -10});
  const NarrowPhase narrow_phase(adapted, left_to_box2d(left));
  for (b2World* world : {&sample, &adapted}) add_stack(*world, 5);
  for (int i = 0; i < 100; ++i) {
    step(sample);
    step(adapted);
    REQUIRE(state_of(sample) == state_of(adapted));
  }
  CHECK(narrow_phase.statistics().pairs == 0);
}

TEST_CASE("other worlds go on as Box2D's, bit by bit") {
  b2World sample({0, -10});
  add_stack(sample, 5);
  step(sample, 100);

  b2World adapted({0, -10}), bystander({0, -10});
  const NarrowPhase narrow_phase(adapted);
  for (b2World* world : {&adapted, &bystander}) add_stack(*world, 5);
  for (int i = 0; i < 100; ++i) {
    step(adapted);
    step(bystander);
  }
  CHECK(state_of(bystander) == state_of(sample));
  CHECK(narrow_phase.statistics().pairs > 0);
}

TEST_CASE("worlds that step in threads of their own go as each would alone") {
  const auto run = [](b2World& world) {
    add_stack(world, 8);
    step(world, 200);
  };
  b2World alone({0, -10}), first({0, -10}), second({0, -10});
  const NarrowPhase of_alone(alone), of_first(first), of_second(second);
  run(alone);
  std::thread other([&] { run(first); });
  run(second);
  other.join();
  CHECK(state_of(first) == state_of(alone));
  CHECK(state_of(second) == state_of(alone));
}

TEST_CASE("begun and ended between two steps, it leaves no trace in a living world") {
  b2World sample({0, -10}), visited({0, -10});
  for (b2World* world : {&sample, &visited}) add_stack(*world, 5);
  for (int i = 0; i < 120; ++i) {
    if (i % 10 == 5) NarrowPhase(visited, {});
    step(sample);
    step(visited);
    REQUIRE(state_of(sample) == state_of(visited));
  }
}

TEST_CASE("contacts are taken over with their impulses, and nobody is told or woken") {
  b2World worlds[2] = {b2World({0, -10}), b2World({0, -10})};
  CountingListener listener;
  for (b2World& world : worlds) {
    add_stack(world, 5);
    step(world, 300);
    world.SetContactListener(&listener);
    REQUIRE_FALSE(world.GetBodyList()->IsAwake());
  }
  const std::vector<b2Contact*> contacts = contacts_of(worlds[0]);
  const std::vector<SolverPoint> before = points_of(worlds[0]);
  {
    const NarrowPhase first(worlds[0]), second(worlds[1]);
    CHECK(contacts_of(worlds[0]) == contacts);
    CHECK(have_same_ids(points_of(worlds[0]), before));
    CHECK_FALSE(worlds[0].GetBodyList()->IsAwake());
    for (b2World& world : worlds) world.GetBodyList()->SetAwake(true);
    step(worlds[0], 10);
    step(worlds[1], 10);
    CHECK(first.statistics().touching > 0);
    CHECK(second.statistics().touching > 0);
    CHECK(have_same_ids(points_of(worlds[0]), before));
  }
  step(worlds[0], 10);
  CHECK(have_same_ids(points_of(worlds[0]), before));
  CHECK(listener.begun == 0);
  CHECK(listener.ended == 0);
}

TEST_CASE("contacts of all kinds end in any order") {
  b2World world({0, -10});
  add_stack(world, 4);
  step(world, 20);  // contacts of Box2D's
  auto narrow_phase = std::make_unique<NarrowPhase>(world);
  world.DestroyBody(world.GetBodyList());  // the top one's, taken over
  add_polygon(world, box_shape(0.5f, 0.5f), {0, 3.6f});
  step(world, 40);  // contacts made here
  world.DestroyBody(world.GetBodyList());
  add_polygon(world, box_shape(0.5f, 0.5f), {0, 3.6f});
  step(world, 40);
  narrow_phase.reset();
  world.DestroyBody(world.GetBodyList());  // one that was made here, after the end
  step(world, 40);
  add_polygon(world, box_shape(0.5f, 0.5f), {0, 3.6f});
  step(world, 40);
  CHECK(points_of(world).size() == 8);
}

TEST_CASE("a fixture may be left to Box2D, and change its mind") {
  b2World world({0, -10});
  world.SetAllowSleeping(false);
  add_polygon(world, box_shape(20, 1), {0, -1}, 0, b2_staticBody);
  b2Fixture& box = add_polygon(world, box_shape(0.5f, 0.5f), {0, 0.52f});
  bool left = true;
  Options options;
  options.geometry_of = [&](b2Fixture& f) { return FixtureGeometry{&f == &box && left, nullptr}; };
  NarrowPhase narrow_phase(world, options);
  step(world, 10);
  CHECK(narrow_phase.statistics().pairs == 0);
  left = false;
  narrow_phase.refresh(box);
  step(world, 10);
  CHECK(narrow_phase.statistics().pairs == 10);
  left = true;
  narrow_phase.refresh(box);
  step(world, 10);
  CHECK(narrow_phase.statistics().pairs == 10);
  narrow_phase.reset_statistics();
  CHECK(narrow_phase.statistics().pairs == 0);
}

TEST_CASE("refresh: a shape that has been changed is looked at anew") {
  b2World world({0, 0});
  NarrowPhase narrow_phase(world);
  add_polygon(world, box_shape(1, 1), {0, 0}, 0, b2_staticBody);
  b2Fixture& small = add_polygon(world, box_shape(0.5f, 0.5f), {0, 1.55f});
  world.Step(0, 1, 1);
  REQUIRE(contacts_of(world).size() == 1);
  CHECK(points_of(world).empty());
  static_cast<b2PolygonShape*>(small.GetShape())->SetAsBox(0.5f, 0.6f);
  narrow_phase.refresh(small);
  world.Step(0, 1, 1);
  CHECK(points_of(world).size() == 2);
}

TEST_CASE("what the host's choice throws leaves the pair to Box2D") {
  b2World world({0, -10});
  Options options;
  options.geometry_of = [](b2Fixture&) -> FixtureGeometry { throw std::runtime_error("no"); };
  const NarrowPhase narrow_phase(world, options);
  add_stack(world, 2);
  step(world, 60);
  CHECK(narrow_phase.statistics().pairs == 0);
  CHECK(points_of(world).size() == 4);
}

TEST_CASE("a pose that is not finite goes to Box2D") {
  b2World world({0, -10});
  const NarrowPhase narrow_phase(world);
  add_stack(world, 1);
  step(world, 5);
  b2PolygonShape box = box_shape(0.5f, 0.5f);
  b2Contact& contact = *contacts_of(world).front();
  b2Transform nowhere({std::nanf(""), 0}, b2Rot(0)), here({0, 0}, b2Rot(0));
  b2Manifold manifold;
  contact.Evaluate(&manifold, nowhere, here);
  CHECK(narrow_phase.statistics().refused == 1);
}

TEST_CASE("a second narrow phase in a world, and one while it steps, are refused") {
  b2World world({0, -10});
  const auto narrow_phase = std::make_unique<NarrowPhase>(world);
  CHECK_THROWS_AS(NarrowPhase(world), std::logic_error);

  class Meddler : public b2ContactListener {
   public:
    void BeginContact(b2Contact* contact) override {
      CHECK_THROWS_AS(NarrowPhase(*contact->GetFixtureA()->GetBody()->GetWorld()), std::logic_error);
      ++asked;
    }
    int asked = 0;
  } meddler;
  b2World stepping({0, -10});
  stepping.SetContactListener(&meddler);
  add_stack(stepping, 1);
  step(stepping, 20);
  CHECK(meddler.asked == 1);
}

TEST_CASE("vertices on a line, which Box2D keeps, do not matter") {
  const b2Vec2 with_middle[] = {{-0.5f, -0.5f}, {0, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}};
  b2PolygonShape shape;
  shape.Set(with_middle, 4);
  std::copy(with_middle, with_middle + 5, shape.m_vertices);
  shape.m_count = 5;
  for (int i = 0; i < 5; ++i) {
    shape.m_normals[i] = b2Cross(shape.m_vertices[(i + 1) % 5] - shape.m_vertices[i], 1.0f);
    shape.m_normals[i].Normalize();
  }
  b2World world({0, -10});
  const NarrowPhase narrow_phase(world);
  add_polygon(world, box_shape(20, 1), {0, -1}, 0, b2_staticBody);
  add_polygon(world, shape, {0, 0.515f});
  step(world, 20);
  CHECK(narrow_phase.statistics().touching > 0);
  CHECK(points_of(world).size() == 2);
}

}  // namespace halfspace_test
