// A block slides down a slope in space (Wang et al. 2021, section 4.1): s = 1/2 (g sin - g cos tan(phi)) t^2.
// The slope lies level and gravity is turned: x is downhill.

#include "catch.h"
#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;

// The paper's own numbers.
constexpr double slope = 30 * degree;
constexpr double gravity = 9.81;
constexpr Triple size{5, 5, 4};
constexpr double stiffness = 1e10;
constexpr double weight = 5 * 5 * 4 * 2500 * gravity;
constexpr double time_step = 1e-5;
constexpr double duration = 5;

double normal_force() { return weight * std::cos(slope); }

/// What friction takes up: all of the weight's share if it can.
double shear_force(double friction_angle) {
  return std::min(normal_force() * std::tan(friction_angle), weight * std::sin(slope));
}

struct Slide {
  Triple way;
  double friction_loss;
};

/// With the springs in equilibrium, or with no force in them at first. In equilibrium the shear force turns
/// the block forward until the normal force is ahead of the centroid by y T / N: springs K/4 under four
/// corners, at
/// (+-w/2 c - h/2 s, +-w/2 s) in the plane of the slide, as in the plane (see sliding_block.cpp).
Slide run(double friction_angle, bool in_equilibrium) {
  SolidScene scene(solid_world_def(time_step, {gravity * std::sin(slope), 0, -gravity * std::cos(slope)}),
                   spring_law(stiffness, friction_angle), 2500);
  const hs_block plane = scene.add_hull(cuboid({400, 20, 2}), {{190, 0, -1}, {0, 0, 0, 1}, HS_BLOCK_FIXED});
  double height = size[2] / 2, tilt = 0;
  const double shear = shear_force(friction_angle);
  for (int i = 0; i < 50 && in_equilibrium; ++i) {
    const double c = std::cos(tilt);
    height = size[2] * c / 2 - normal_force() / stiffness;
    tilt =
        std::asin(height * shear / (stiffness * square_of(size[0]) * c / 4 - normal_force() * size[2] / 2));
  }
  const hs_block block = scene.add_hull(cuboid(size), {{0, 0, height}, turn_about({0, 1, 0}, tilt)});
  scene.check(hs_world_detect(scene.world(), nullptr));
  if (in_equilibrium) {
    REQUIRE(scene.contact_type() == HS_CONTACT_FACE_FACE);
    const double on_block[3] = {-shear, 0, 0};
    scene.check(hs_world_set_shear_force(scene.world(), plane, block, on_block));
  }
  scene.step(std::llround(duration / time_step));
  return {scene.place_of(block) - Triple{0, 0, height}, scene.energy().friction_loss};
}

/// As in the plane: what is left in equilibrium is rounding of the block's place. Coordinates of some 10 m
/// (rounding 2e-15 m) give the overlap N/K = 2e-4 m an error of 1e-11, shaken once more with every of 5e5
/// steps: sqrt(steps) of them, all of one sign, are 8e-9.
constexpr double required = 1e-4;
constexpr double derived = 8e-9;

TEST_CASE("A4.1 in space: a block of 5 x 5 x 4 m slides down 30 degrees as the formula says") {
  for (const double friction : {15.0, 20.0, 25.0}) {
    const double acceleration = gravity * (std::sin(slope) - std::cos(slope) * std::tan(friction * degree));
    const double exact = 0.5 * acceleration * square_of(duration);
    const Slide slide = run(friction * degree, true);
    const double error = slide.way[0] / exact - 1;
    std::printf(
        "A4.1 in space, friction %2.0f deg: slide %.9f m, relative error %9.2e (not in equilibrium at first "
        "%9.2e), sideways %.1e m\n",
        friction, slide.way[0], error, run(friction * degree, false).way[0] / exact - 1, slide.way[1]);
    CHECK(std::abs(error) <= required);
    CHECK(std::abs(error) <= derived);
    CHECK(std::abs(slide.way[1]) <= derived * exact);
    CHECK(std::abs(slide.friction_loss / (shear_force(friction * degree) * slide.way[0]) - 1) <= derived);
  }
}

TEST_CASE("A4.1 in space: a block stays on a slope as steep as its friction angle") {
  const double creep = run(slope, true).way[0] / size[0];
  std::printf("A4.1 in space, friction 30 deg: creep in 5 s %.2e of the width\n", creep);
  // 8e-9 of the free slide of 1/2 g sin t^2 = 61 m.
  CHECK(std::abs(creep) < 1e-7);
}

}  // namespace
