// A Box2D world as a world of the library, and back.

#include <cmath>
#include <halfspace/box2d_world.hpp>

#include "catch.h"
#include "world_fixture.h"

namespace halfspace_test {
namespace {

using halfspace::box2d::WorldCopy;

hs_law_def stiff_law() {
  hs_law_def law;
  require_ok(hs_law_def_init(&law, sizeof law), nullptr);
  law.normal_stiffness = law.shear_stiffness = 1e6;
  law.normal_damping = law.shear_damping = 0.2;
  return law;
}

void run(hs_world* world, double seconds) {
  hs_world_report report{};
  if (hs_world_get_report(world, &report, sizeof report) != HS_OK) throw std::runtime_error("no report");
  REQUIRE(report.time_step > 0);
  REQUIRE(hs_world_step(world, std::int64_t(std::ceil(seconds / report.time_step))) == HS_OK);
}

hs_block_state state_of(const WorldCopy& copy, const b2Fixture& fixture) {
  hs_block_state state{};
  if (hs_world_get_block_state(copy.world(), copy.block_of(fixture), &state) != HS_OK)
    throw std::runtime_error("no state");
  return state;
}

}  // namespace

TEST_CASE("a copy has the poses and velocities of its source, and gives them back") {
  b2World world({0.5f, -10});
  add_polygon(world, box_shape(20, 1), {0, -1}, 0, b2_staticBody);
  Random random(1);
  std::vector<b2Fixture*> made;
  for (int i = 0; i < 20; ++i) {
    const PosedPolygons pair = draw_polygons(0, 0.1, random);
    b2Fixture& fixture = add_polygon(world, pair.a, {3.f * float(i), 5}, pair.angle_a + 20);
    fixture.GetBody()->SetLinearVelocity({0.25f, float(i)});
    fixture.GetBody()->SetAngularVelocity(-0.5f * float(i));
    made.push_back(&fixture);
  }
  const std::vector<float> before = state_of(world);
  WorldCopy copy(world, stiff_law());
  CHECK(copy.bodies_left_out() == 0);
  for (const b2Fixture* fixture : made) {
    const hs_block_state state = state_of(copy, *fixture);
    const b2Body& body = *fixture->GetBody();
    CHECK(state.pose.position[0] == Approx(body.GetWorldCenter().x).epsilon(1e-6));
    CHECK(state.pose.position[1] == Approx(body.GetWorldCenter().y).epsilon(1e-6));
    CHECK(state.angular_velocity[2] == body.GetAngularVelocity());
  }
  copy.write_back();
  const std::vector<float> after = state_of(world);
  REQUIRE(before.size() == after.size());
  // A body's angle of up to 24 rad comes back from its cosine and sine; a velocity from that of a centroid.
  for (std::size_t i = 0; i < before.size(); ++i) CHECK(std::abs(before[i] - after[i]) < 24 * 0x1p-22);
}

TEST_CASE("a thrown block flies the same parabola and keeps its spin") {
  b2World world({0, -10});
  b2Fixture& block = add_polygon(world, box_shape(0.5f, 0.25f), {0, 0});
  block.GetBody()->SetLinearVelocity({3, 4});
  block.GetBody()->SetAngularVelocity(5);
  WorldCopy copy(world, stiff_law());
  run(copy.world(), 1);
  hs_world_report report{};
  REQUIRE(hs_world_get_report(copy.world(), &report, sizeof report) == HS_OK);
  const double t = report.time;
  copy.write_back();
  const b2Body& body = *block.GetBody();
  CHECK(body.GetPosition().x == Approx(3 * t).epsilon(1e-5));
  CHECK(body.GetPosition().y == Approx(4 * t - 5 * t * t).margin(1e-4));
  CHECK(body.GetLinearVelocity().y == Approx(4 - 10 * t).epsilon(1e-5));
  CHECK(body.GetAngularVelocity() == 5);
}

TEST_CASE("a block slides down a slope with the friction that Box2D mixes") {
  const float slope = 0.5f;
  const b2Rot turn(slope);
  b2World world({0, -10});
  add_polygon(world, box_shape(50, 1), {0, 0}, slope, b2_staticBody).SetFriction(0.4f);
  b2Fixture& block = add_polygon(world, box_shape(1, 0.5f), 1.5f * turn.GetYAxis(), slope);
  block.SetFriction(0.1f);  // mixed with 0.4: 0.2
  WorldCopy copy(world, stiff_law());
  run(copy.world(), 0.5);
  const hs_block_state early = state_of(copy, block);
  run(copy.world(), 1);
  const hs_block_state late = state_of(copy, block);
  const double gained =
      std::hypot(late.velocity[0] - early.velocity[0], late.velocity[1] - early.velocity[1]);
  CHECK(gained == Approx(10 * (turn.s - 0.2 * turn.c)).epsilon(0.01));
}

TEST_CASE("a mass that was set by hand is the block's") {
  b2World world({0, -10});
  add_polygon(world, box_shape(20, 1), {0, -1}, 0, b2_staticBody);
  b2Fixture& block = add_polygon(world, box_shape(0.5f, 0.5f), {0, 0.5f});
  b2MassData mass;
  block.GetBody()->GetMassData(&mass);
  mass.mass *= 7;
  mass.I *= 7;
  block.GetBody()->SetMassData(&mass);
  WorldCopy copy(world, stiff_law());
  run(copy.world(), 2);
  // At rest on two springs of the law, or one per edge: the force is the weight of 7 kg.
  hs_contact contact{};
  std::int64_t count = 0;
  REQUIRE(hs_world_get_contacts(copy.world(), &contact, 1, &count) == HS_OK);
  REQUIRE(count == 1);
  CHECK(contact.normal_force == Approx(70).epsilon(1e-3));
}

TEST_CASE("what cannot be taken is left out and told") {
  b2World world({0, -10});
  add_polygon(world, box_shape(20, 1), {0, -1}, 0, b2_staticBody);
  b2Fixture& two = add_polygon(world, box_shape(0.5f, 0.5f), {0, 1});
  const b2PolygonShape other = box_shape(0.1f, 1);
  two.GetBody()->CreateFixture(&other, 1);
  b2BodyDef round;
  round.type = b2_dynamicBody;
  b2CircleShape circle;
  circle.m_radius = 1;
  world.CreateBody(&round)->CreateFixture(&circle, 1);
  b2Fixture& taken = add_polygon(world, box_shape(0.5f, 0.5f), {5, 1});
  WorldCopy copy(world, stiff_law());
  CHECK(copy.bodies_left_out() == 2);
  CHECK(copy.block_of(two) == 0);
  CHECK(copy.block_of(taken) != 0);
  hs_law_def wrong = stiff_law();
  wrong.normal_stiffness = -1;
  CHECK_THROWS_AS(WorldCopy(world, wrong), std::invalid_argument);
}

}  // namespace halfspace_test
