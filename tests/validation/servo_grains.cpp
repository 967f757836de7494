// A servo presses on 500 grains in a shear box while the upper half of the box moves.

#include <utility>
#include <vector>

#include "validation/actions.h"

namespace {

using namespace halfspace_test;

constexpr int columns = 25, rows = 20;
constexpr double width = columns * 1.1, stress = 2e5;
constexpr double load = stress * width;
constexpr double shear_velocity = 0.02;  // m/s
constexpr double smoothing_time = 0.1;   // s

/// A polygon of seven corners around a circle, turned differently for each grain.
Points grain(int number) {
  Points corners;
  for (int k = 0; k < 7; ++k) {
    const double angle = 2 * pi * (k + 0.3 * std::sin(5.0 * k + number)) / 7 + number;
    corners.push_back({0.5 * std::cos(angle), 0.5 * std::sin(angle)});
  }
  return corners;
}

/// The box, open at half of the height of the grains, and its lid. There is no gravity.
struct ShearBox {
  Scene scene;
  hs_block lid = 0;
  std::vector<hs_block> lower_half{}, upper_walls{};

  double force_on(hs_block block) const { return scene.state(block).force[1]; }
  double force_on(const std::vector<hs_block>& blocks) const {
    double sum = 0;
    for (const hs_block block : blocks) sum += force_on(block);
    return sum;
  }
};

ShearBox shear_box() {
  hs_law_def law = spring_law(1e8, 25 * degree);
  law.stiffness_kind = HS_STIFFNESS_PER_AREA;
  law.normal_damping = law.shear_damping = 0.3;
  hs_world_def def = world_def(0, 0);
  def.local_damping = 0.3;
  ShearBox made{Scene(def, law, 2000)};
  Scene& scene = made.scene;
  const auto fixed = [&](const Points& corners) { return scene.add(corners, {HS_BLOCK_FIXED, {}, 0}); };
  const auto prescribed = [&](const Points& corners) {
    return scene.add(corners, {HS_BLOCK_PRESCRIBED, {}, 0});
  };
  const double split = rows * 1.05 / 2 - 0.5, top = rows * 1.05;
  made.lower_half = {fixed(box(-2, -1, width + 2, 0)), fixed(box(-1, 0, 0, split)),
                     fixed(box(width, 0, width + 1, split))};
  made.upper_walls = {prescribed(box(-1, split, 0, top + 3)),
                      prescribed(box(width, split, width + 1, top + 3))};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column)
      scene.add_at(grain(row * columns + column), {0.55 + 1.1 * column, 0.55 + 1.05 * row}, 0);
  }
  made.lid = prescribed(box(0.02, top + 0.3, width - 0.02, top + 2));
  act(scene, made.lid, HS_ACTION_SERVO, {{0, 0, -load}}, [](hs_action_def& action) {
    action.max_speed = 1;
    action.scale[0] = action.scale[2] = 0;
  });
  return made;
}

}  // namespace

TEST_CASE("a servo holds its stress within 1 % while 500 grains are sheared") {
  ShearBox sheared = shear_box();
  const Scene& scene = sheared.scene;
  const auto run_until = [&](double time, auto visit) {
    while (scene.report().time < time) {
      sheared.scene.step(10);
      visit();
    }
  };
  run_until(7, [] {});  // the loose grains collapse
  for (const hs_block wall : sheared.upper_walls) sheared.scene.set_velocity(wall, {shear_velocity, 0});
  sheared.scene.set_velocity(sheared.lid, {shear_velocity, 0});
  const double height_before = scene.position(sheared.lid).y;
  double lid = 0, walls = 0, base = 0, squares = 0, smoothed = 0, largest_smoothed = 0;
  int count = 0;
  double time = scene.report().time;
  run_until(17, [&] {
    const double error = sheared.force_on(sheared.lid) / load - 1;
    const double passed = scene.report().time - std::exchange(time, scene.report().time);
    smoothed += passed / smoothing_time * (error - smoothed);
    largest_smoothed = std::max(largest_smoothed, std::abs(smoothed));
    lid += error;
    squares += error * error;
    walls += sheared.force_on(sheared.upper_walls) / load;
    base += sheared.force_on(sheared.lower_half) / load;
    ++count;
  });
  const double mean = lid / count, deviation = std::sqrt(squares / count);
  const double carried = -(base + walls) / count;
  const double moved = scene.position(sheared.upper_walls[0]).x;
  std::printf(
      "servo on 500 sheared grains: mean error %.2e, root mean square %.2e, largest over 0.1 s %.2e; "
      "the lower half and the upper walls carry %.5f and %.5f of the load; sheared by %.3f m, lid by %.3f "
      "m\n",
      mean, deviation, largest_smoothed, -base / count, -walls / count, moved + 0.5,
      scene.position(sheared.lid).y - height_before);
  CHECK(std::abs(mean) < 0.01);
  CHECK(deviation < 0.01);
  CHECK(carried == Approx(1).epsilon(0.01));  // by all other walls: the grains keep their momentum
}
