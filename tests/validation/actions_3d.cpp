// Motions and loads in time, in space: impulses and displacements of tables are exact at any time step.

#include "validation/actions.h"
#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;

constexpr double mass = 2000, inertia = mass / 6;  // of the cube, about any axis

SolidScene free_scene(double time_step, double gravity = 0) {
  return SolidScene(solid_world_def(time_step, {0, 0, gravity}), spring_law(1e6), 2000);
}

hs_block add_cube(SolidScene& scene, const SolidStart& start = {}) {
  return scene.add_hull(cuboid({1, 1, 1}), start);
}

Triple spin_of(const SolidScene& scene, hs_block block) {
  return triple(scene.state(block).angular_velocity);
}
Triple velocity_of(const SolidScene& scene, hs_block block) { return triple(scene.state(block).velocity); }

void check_equal(const Triple& value, const Triple& expected) {
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(value[k] == Approx(expected[k]).epsilon(1e-12).margin(1e-12 * length(expected)));
}

/// The angle of a turn about an axis of unit length.
double angle_about(const Triple& axis, const hs_pose& pose) {
  return 2 * std::atan2(dot(axis, triple(pose.rotation)), pose.rotation[3]);
}

}  // namespace

TEST_CASE("an impulse in space gives its momentum at any time step") {
  const TableRows pulse = {
      {0.0131}, {0.0277, 900, -300, 40}, {0.0277, -50, 70, 30}, {0.0911, 20, 10, 0}, {0.0911}};
  const double first = 0.0146 / 2, second = 0.0634 / 2;
  const Triple impulse{900 * first - 30 * second, -300 * first + 80 * second, 40 * first + 30 * second};
  for (const double time_step : {1e-3, 1e-2, 0.07, 1.0}) {
    SolidScene scene = free_scene(time_step);
    const hs_block block = add_cube(scene);
    act(scene, block, HS_ACTION_FORCE, pulse);
    act(scene, block, HS_ACTION_TORQUE, pulse);
    scene.step(std::int64_t(std::ceil(0.1 / time_step)) + 1);
    check_equal(velocity_of(scene, block), (1 / mass) * impulse);
    check_equal(spin_of(scene, block), (1 / inertia) * impulse);
    CHECK(std::abs(scene.energy().residual) <= 1e-12 * scene.energy().kinetic);
  }
}

TEST_CASE("in space a force at a carried point turns the block, one at a fixed point loses its arm") {
  const double force = 100, arm = 0.5;
  SolidScene scene = free_scene(1e-4);
  const hs_block carried = add_cube(scene), fixed = add_cube(scene, {{100, 0, 0}});
  act(scene, carried, HS_ACTION_FORCE, {{0, 0, 0, force}}, [&](hs_action_def& def) {
    def.place = HS_PLACE_CARRIED;
    def.point[0] = arm;
  });
  act(scene, fixed, HS_ACTION_FORCE, {{0, 0, force}}, [&](hs_action_def& def) {
    def.place = HS_PLACE_FIXED;
    def.point[0] = 100;
    def.point[2] = arm;
  });
  scene.step(10000);
  // The point is lifted by arm sin(angle) relative to the centroid.
  const double spin = spin_of(scene, carried)[1];
  const double angle = angle_about({0, -1, 0}, scene.state(carried).pose);
  CHECK(angle > 0.05);
  CHECK(inertia * spin * spin / 2 == Approx(force * arm * std::sin(angle)).epsilon(1e-7));
  check_equal(velocity_of(scene, carried), {0, 0, force / mass});
  check_equal(velocity_of(scene, fixed), {0, force / mass, 0});
  check_equal(spin_of(scene, fixed), {-force * arm / inertia, 0, 0});
  CHECK(std::abs(scene.energy().residual) <= 1e-7 * scene.energy().kinetic);
}

TEST_CASE("a prescribed block in space moves and turns by the integral of its table") {
  const Triple axis{2 / 7.0, 3 / 7.0, 6 / 7.0};
  for (const double time_step : {1e-3, 1e-2, 0.07}) {
    SolidScene scene = free_scene(time_step);
    SolidStart start;
    start.kind = HS_BLOCK_PRESCRIBED;
    start.velocity = {0, 0.5, 0};
    const hs_block block = add_cube(scene, start);
    act(scene, block, HS_ACTION_VELOCITY, {{0}, {0.21, 2, 0, 1}, {0.63, -1, 0, 3}, {0.7}},
        [](hs_action_def& def) { def.scale[1] = 0; });
    act(scene, block, HS_ACTION_ANGULAR_VELOCITY,
        {{0}, {0.35, 4 * axis[0], 4 * axis[1], 4 * axis[2]}, {0.7}});
    scene.step(std::llround(0.7 / time_step));
    check_equal(scene.place_of(block), {0.21 + 0.21 - 0.035, 0.35, 0.105 + 0.84 + 0.105});
    CHECK(angle_about(axis, scene.state(block).pose) == Approx(1.4).epsilon(1e-12));
    CHECK(length(spin_of(scene, block)) <= 1e-12);
  }
}

TEST_CASE("a table of gravity accelerates all blocks in space, and held axes do not move") {
  constexpr double time_step = 0.01, weight = mass * 9.81;
  SolidScene scene = free_scene(time_step, -9.81);
  const hs_block loose = add_cube(scene);
  SolidStart start{{10, 0, 0}};
  start.velocity = {0.25, 0, 0};
  const hs_block held = add_cube(scene, start);
  hold(scene, held, HS_AXIS_X | HS_AXIS_Z | HS_AXIS_ROTATION);
  act(scene, 0, HS_ACTION_ACCELERATION, {{0}, {1, 3, 1, 9.81}, {1}});
  act(scene, held, HS_ACTION_TORQUE, {{0, 100, 200, 300}});
  act(scene, held, HS_ACTION_VELOCITY, {{0, 0, 0, 2}},
      [](hs_action_def& def) { def.scale[0] = def.scale[1] = 0; });
  scene.step(200);
  check_equal(velocity_of(scene, loose), {1.5, 0.5, -9.81 * 1.5});
  check_equal(velocity_of(scene, held), {0.25, 0.5, 2});
  CHECK(scene.place_of(held)[0] == Approx(10.5).epsilon(1e-12));
  CHECK(scene.place_of(held)[2] == Approx(4).epsilon(1e-12));
  // Along the free axis the path is that of velocity Verlet, of second order in the step.
  CHECK(scene.place_of(held)[1] == Approx(1.0 / 6 + 0.5).margin(time_step * time_step));
  CHECK(length(spin_of(scene, held)) == 0);
  // The work of a support against a load that changes is a trapezoidal sum, which leaves half a step of it.
  CHECK(std::abs(scene.energy().residual) <= 0.5 * time_step * 2 * weight);
}
