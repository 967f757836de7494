// Motions and loads in time: impulses and displacements of tables are exact at any time step.

#include "validation/actions.h"

namespace {

using namespace halfspace_test;

Scene free_scene(double time_step, double gravity = 0) {
  return Scene(world_def(time_step, gravity), spring_law(1e6), 2000);
}

/// Its rows do not meet the ends of steps of 0.01 s.
const TableRows pulse = {
    {0.0131, 0, 0, 0}, {0.0277, 900, -300, 40}, {0.0277, -50, 70, 3}, {0.0911, 20, 10, 0}};

/// The integral over all rows; the value after them is 0 here by construction of the tests.
TableRow integral_of(const TableRows& rows) {
  TableRow sum{0};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double half = (rows[i].time - rows[i - 1].time) / 2;
    sum.x += half * (rows[i].x + rows[i - 1].x);
    sum.y += half * (rows[i].y + rows[i - 1].y);
    sum.z += half * (rows[i].z + rows[i - 1].z);
  }
  return sum;
}

TableRows then_nothing(TableRows rows) {
  rows.push_back({rows.back().time});
  return rows;
}

}  // namespace

TEST_CASE("an impulse gives its momentum at any time step") {
  for (const double time_step : {1e-3, 1e-2, 0.07, 1.0}) {
    Scene scene = free_scene(time_step);
    const hs_block block = scene.add(rectangle(1, 1));
    const double mass = 2000, inertia = mass / 6;
    act(scene, block, HS_ACTION_FORCE, then_nothing(pulse));
    act(scene, block, HS_ACTION_TORQUE, then_nothing(pulse));
    scene.step(std::int64_t(std::ceil(0.1 / time_step)) + 1);
    const TableRow impulse = integral_of(pulse);
    CHECK(mass * scene.velocity(block).x == Approx(impulse.x).epsilon(1e-12));
    CHECK(mass * scene.velocity(block).y == Approx(impulse.y).epsilon(1e-12));
    CHECK(inertia * scene.spin(block) == Approx(impulse.z).epsilon(1e-12));
    const hs_energy energy = scene.energy();
    CHECK(std::abs(energy.residual) <= 1e-12 * energy.kinetic);
    CHECK(energy.outer_work == Approx(energy.kinetic).epsilon(1e-12));
  }
}

TEST_CASE("a force at a carried point turns the block, one at a fixed point loses its arm") {
  Scene scene = free_scene(1e-4);
  const hs_block carried = scene.add(rectangle(1, 1));
  const hs_block fixed = scene.add_at(rectangle(1, 1), {100, 0}, 0);
  const double mass = 2000, inertia = mass / 6, force = 100, arm = 0.5;
  act(scene, carried, HS_ACTION_FORCE, {{0, 0, force}}, [&](hs_action_def& def) {
    def.place = HS_PLACE_CARRIED;
    def.point[0] = arm;
  });
  act(scene, fixed, HS_ACTION_FORCE, {{0, force}}, [&](hs_action_def& def) {
    def.place = HS_PLACE_FIXED;
    def.point[0] = 100;
    def.point[1] = arm;
  });
  scene.step(10000);
  // A force of constant direction at a carried point does the work F arm sin(angle), as gravity on a
  // pendulum.
  const hs_block_state turned = scene.state(carried);
  const double energy = inertia * square_of(turned.angular_velocity[2]) / 2;
  CHECK(energy == Approx(force * arm * std::sin(turned.angle)).epsilon(1e-7));
  // The block moves along the force only: its line keeps the distance `arm` from the centroid.
  CHECK(mass * scene.velocity(fixed).x == Approx(force).epsilon(1e-12));
  CHECK(inertia * scene.spin(fixed) == Approx(-force * arm).epsilon(1e-12));
  CHECK(std::abs(scene.energy().residual) <= 1e-7 * scene.energy().kinetic);
}

TEST_CASE("a prescribed block moves by the integral of its table") {
  for (const double time_step : {1e-3, 1e-2, 0.07}) {
    Scene scene = free_scene(time_step);
    Start start{HS_BLOCK_PRESCRIBED, {0, 0.5}, 0};
    const hs_block by_velocity = scene.add(rectangle(1, 1), start);
    const hs_block by_acceleration =
        scene.add_at(rectangle(1, 1), {10, 0}, 0, {HS_BLOCK_PRESCRIBED, {3, 0}, 0});
    act(scene, by_velocity, HS_ACTION_VELOCITY, {{0, 0}, {0.21, 2}, {0.63, -1}, {0.7, 0}}, only_x);
    act(scene, by_velocity, HS_ACTION_ANGULAR_VELOCITY, {{0, 0, 0, 0}, {0.35, 0, 0, 4}, {0.7}});
    act(scene, by_acceleration, HS_ACTION_ACCELERATION, {{0, 0}, {0.7, 6}});
    scene.step(std::llround(0.7 / time_step));
    const double time = scene.report().time;
    CHECK(scene.position(by_velocity).x == Approx(0.21 + 0.21 - 0.035).epsilon(1e-12));
    CHECK(scene.position(by_velocity).y == Approx(0.5 * time).epsilon(1e-12));
    CHECK(scene.state(by_velocity).angle == Approx(1.4).epsilon(1e-12));
    CHECK(std::abs(scene.velocity(by_velocity).x) <= 1e-12);
    CHECK(scene.velocity(by_acceleration).x == Approx(3 + 2.1).epsilon(1e-12));
    CHECK(scene.position(by_acceleration).x == Approx(10 + 3 * 0.7 + 6 * 0.49 / 6).epsilon(1e-12));
  }
}

TEST_CASE("an acceleration of all blocks adds to gravity") {
  Scene scene = free_scene(0.01, -9.81);
  const hs_block block = scene.add(rectangle(1, 1));
  act(scene, 0, HS_ACTION_ACCELERATION, {{0, 0}, {1, 3}, {1, 0}});
  scene.step(200);
  CHECK(scene.velocity(block).x == Approx(1.5).epsilon(1e-12));
  CHECK(scene.velocity(block).y == Approx(-19.62).epsilon(1e-12));
  CHECK(std::abs(scene.energy().residual) <= 1e-11 * scene.energy().kinetic);
}

TEST_CASE("held axes keep their velocity, and their supports do the work") {
  for (const int32_t kind : {HS_STIFFNESS_PER_AREA, HS_STIFFNESS_NONE}) {
    hs_law_def law = spring_law(1e8);
    law.stiffness_kind = kind;
    Scene scene(world_def(2e-4), law, 2000);
    scene.add(box(-5, -1, 5, 0), {HS_BLOCK_FIXED, {}, 0});
    const hs_block block = scene.add(box(-0.5, 0, 0.5, 1), {HS_BLOCK_RIGID, {0.3, 0}, 0});
    hold(scene, block, HS_AXIS_X | HS_AXIS_ROTATION);
    scene.apply(block, {700, 0}, 5);
    scene.step(5000);
    CHECK(scene.velocity(block).x == 0.3);
    CHECK(scene.spin(block) == 0);
    CHECK(scene.position(block).x == Approx(0.3).epsilon(1e-12));
    // It bounces on its springs by twice its settlement; energies oscillate by the square of the step.
    CHECK(std::abs(scene.velocity(block).y) <= 9.81 * std::sqrt(2000 / 1e8));
    CHECK(std::abs(scene.energy().residual) <= 1e-4 * 2000 * 9.81 * (2000 * 9.81 / 1e8));
    hold(scene, block, 0);
    scene.step(10);
    CHECK(scene.velocity(block).x > 0.3);
  }
}

TEST_CASE("direct shear under a constant normal load reaches N tan(phi)") {
  const double friction_angle = 30 * degree, load = 5e5;
  for (const int32_t kind : {HS_STIFFNESS_PER_AREA, HS_STIFFNESS_NONE}) {
    hs_law_def law = spring_law(1e10, friction_angle);
    law.stiffness_kind = kind;
    law.normal_damping = law.shear_damping = 0.2;
    Scene scene(world_def(kind == HS_STIFFNESS_NONE ? 1e-3 : 2e-4, 0), law, 2000);
    scene.add(box(-2, -1, 3, 0), {HS_BLOCK_FIXED, {}, 0});
    const hs_block upper = scene.add(box(0, 0, 1, 0.5));
    hold(scene, upper, HS_AXIS_X | HS_AXIS_ROTATION);
    act(scene, upper, HS_ACTION_FORCE, {{0}, {0.05, 0, -load}});
    act(scene, upper, HS_ACTION_VELOCITY, {{0}, {0.1}, {0.2, 0.01}}, only_x);
    scene.step(kind == HS_STIFFNESS_NONE ? 1000 : 5000);
    const hs_block_state state = scene.state(upper);
    std::array<double, 2> force{};
    for (const hs_contact& contact : scene.contacts()) {
      for (std::size_t k = 0; k < 2; ++k)
        force[k] += contact.normal_force * contact.normal[k] + contact.shear_force[k];
    }
    CHECK(force[1] == Approx(load).epsilon(1e-3));
    CHECK(-force[0] == Approx(load * std::tan(friction_angle)).epsilon(1e-3));
    CHECK(state.velocity[0] == 0.01);
    std::printf("direct shear, stiffness kind %d: shear over N tan(phi) %.6f\n", kind,
                -force[0] / (load * std::tan(friction_angle)));
  }
}

TEST_CASE("a servo presses with its force on a column") {
  hs_law_def law = spring_law(1e8);
  law.stiffness_kind = HS_STIFFNESS_PER_AREA;
  law.normal_damping = 0.3;
  hs_world_def def = world_def(1e-4, 0);
  def.local_damping = 0.3;
  Scene scene(def, law, 2000);
  scene.add(box(-1, -1, 2, 0), {HS_BLOCK_FIXED, {}, 0});
  for (int i = 0; i < 5; ++i) scene.add(box(0, i, 1, i + 1));
  const hs_block plate = scene.add(box(-1, 5, 2, 6), {HS_BLOCK_PRESCRIBED, {}, 0});
  act(scene, plate, HS_ACTION_SERVO, {{0, 0, -1e5}, {1, 0, -1e5}, {1, 0, -3e5}}, [](hs_action_def& action) {
    action.max_speed = 1;
    action.scale[0] = action.scale[2] = 0;
  });
  scene.step(10000);
  CHECK(scene.state(plate).force[1] == Approx(1e5).epsilon(1e-3));
  scene.step(10000);
  CHECK(scene.state(plate).force[1] == Approx(3e5).epsilon(1e-3));
}

TEST_CASE("a servo feeds no vibration of springs without dashpots") {
  hs_law_def law = spring_law(1e8);
  law.stiffness_kind = HS_STIFFNESS_PER_AREA;
  Scene scene(world_def(1e-4, 0), law, 2000);
  scene.add(box(-1, -1, 2, 0), {HS_BLOCK_FIXED, {}, 0});
  for (int i = 0; i < 5; ++i) scene.add(box(0, i, 1, i + 1));
  const hs_block plate = scene.add(box(-1, 5, 2, 6), {HS_BLOCK_PRESCRIBED, {}, 0});
  act(scene, plate, HS_ACTION_SERVO, {{0, 0, -1e5}}, [](hs_action_def& action) {
    action.max_speed = 1;
    action.scale[0] = action.scale[2] = 0;
  });
  const auto largest_error = [&] {
    double largest = 0;
    for (int i = 0; i < 5000; ++i) {
      scene.step();
      largest = std::max(largest, std::abs(scene.state(plate).force[1] / 1e5 - 1));
    }
    return largest;
  };
  scene.step(1000);  // the whole load arrives at once
  const double first = largest_error();
  scene.step(10000);
  const double last = largest_error();
  std::printf("vibration of an undamped column under a servo: error %.2e at first, %.2e at last\n", first,
              last);
  CHECK(last < first);
}

TEST_CASE("a restored world follows its tables bit for bit") {
  Scene scene = free_scene(0.01, -9.81);
  const hs_block prescribed = scene.add(rectangle(1, 1), {HS_BLOCK_PRESCRIBED, {}, 0});
  const hs_block rigid = scene.add_at(rectangle(1, 1), {5, 0}, 0);
  act(scene, prescribed, HS_ACTION_ACCELERATION, {{0, 0}, {3, 2, 1}});
  act(scene, rigid, HS_ACTION_FORCE, {{0, 10}, {2, -500, 30}}, [](hs_action_def& def) {
    def.place = HS_PLACE_CARRIED;
    def.point[0] = 5.25;
  });
  scene.step(50);
  std::size_t size = 0;
  (void)hs_world_save(scene.world(), nullptr, 0, &size);
  std::vector<char> saved(size);
  scene.check(hs_world_save(scene.world(), saved.data(), size, &size));
  hs_world* copy = nullptr;
  scene.check(hs_world_restore(scene.context(), saved.data(), size, &copy));
  const World restored(copy);
  scene.apply(rigid, {1, 2}, 3);
  const double force[3] = {1, 2, 0}, torque[3] = {0, 0, 3};
  scene.check(hs_world_set_applied_force(copy, rigid, force, torque));
  scene.step(50);
  scene.check(hs_world_step(copy, 50));
  for (const hs_block block : {prescribed, rigid}) {
    hs_block_state state;
    scene.check(hs_world_get_block_state(copy, block, &state));
    CHECK(state.pose.position[0] == scene.position(block).x);
    CHECK(state.pose.position[1] == scene.position(block).y);
    CHECK(state.angular_velocity[2] == scene.spin(block));
  }
}
