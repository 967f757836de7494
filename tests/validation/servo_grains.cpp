// A servo presses on 500 grains in a shear box while the upper half of the box moves.

#include "validation/actions.h"

namespace {

using namespace halfspace_test;

constexpr int columns = 25, rows = 20;
constexpr double width = columns * 1.1, stress = 2e5;

/// A polygon of seven corners around a circle, turned differently for each grain.
Points grain(int number) {
  Points corners;
  for (int k = 0; k < 7; ++k) {
    const double angle = 2 * pi * (k + 0.3 * std::sin(5.0 * k + number)) / 7 + number;
    corners.push_back({0.5 * std::cos(angle), 0.5 * std::sin(angle)});
  }
  return corners;
}

/// The box, open at half of the height of the grains, and its plate.
struct ShearBox {
  Scene scene;
  hs_block plate = 0;
  std::array<hs_block, 2> upper_walls{};

  double stress_on_plate() const { return scene.state(plate).force[1] / width; }
};

ShearBox shear_box() {
  hs_law_def law = spring_law(1e8, 25 * degree);
  law.stiffness_kind = HS_STIFFNESS_PER_AREA;
  law.normal_damping = law.shear_damping = 0.3;
  hs_world_def def = world_def(0, 0);
  def.local_damping = 0.3;
  ShearBox made{Scene(def, law, 2000)};
  Scene& scene = made.scene;
  const double middle = rows * 1.05 / 2, top = rows * 1.05;
  scene.add(box(-2, -1, width + 2, 0), {HS_BLOCK_FIXED, {}, 0});
  scene.add(box(-1, 0, 0, middle - 0.5), {HS_BLOCK_FIXED, {}, 0});
  scene.add(box(width, 0, width + 1, middle - 0.5), {HS_BLOCK_FIXED, {}, 0});
  made.upper_walls = {scene.add(box(-1, middle - 0.5, 0, top + 3), {HS_BLOCK_PRESCRIBED, {}, 0}),
                      scene.add(box(width, middle - 0.5, width + 1, top + 3), {HS_BLOCK_PRESCRIBED, {}, 0})};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column)
      scene.add_at(grain(row * columns + column), {0.55 + 1.1 * column, 0.55 + 1.05 * row}, 0);
  }
  made.plate = scene.add(box(0.02, top + 0.3, width - 0.02, top + 2), {HS_BLOCK_PRESCRIBED, {}, 0});
  act(scene, made.plate, HS_ACTION_SERVO, {{0, 0, -stress * width}}, [](hs_action_def& action) {
    action.max_speed = 1;
    action.scale[0] = action.scale[2] = 0;
  });
  return made;
}

}  // namespace

TEST_CASE("a servo holds its stress within 1 % while 500 grains are sheared") {
  ShearBox sheared = shear_box();
  const auto run_until = [&](double time, auto visit) {
    while (sheared.scene.report().time < time) {
      sheared.scene.step(10);
      visit();
    }
  };
  run_until(6, [] {});
  for (const hs_block wall : sheared.upper_walls) sheared.scene.set_velocity(wall, {0.02, 0});
  sheared.scene.set_velocity(sheared.plate, {0.02, 0});
  double sum = 0, squares = 0, largest = 0;
  int count = 0;
  run_until(16, [&] {
    const double error = sheared.stress_on_plate() / stress - 1;
    sum += error;
    squares += error * error;
    largest = std::max(largest, std::abs(error));
    ++count;
  });
  const double mean = sum / count, deviation = std::sqrt(squares / count);
  std::printf("servo on 500 sheared grains: mean error %.2e, root mean square %.2e, largest %.2e\n", mean,
              deviation, largest);
  CHECK(std::abs(mean) < 0.01);
  CHECK(deviation < 0.01);
}
