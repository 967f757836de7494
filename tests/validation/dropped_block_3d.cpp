// Blocks that fall on a fixed one (Wang et al. 2021, section 4.2): which contact types they pass.

#include "catch.h"
#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;

// The paper's figures do not give the blocks' sizes: cubes of 1 m.
constexpr double density = 2500;
constexpr double friction = 30 * degree;

/// The types that contacts begin with, each at its first time.
struct TypesInOrder {
  std::vector<std::int32_t> types;

  void note(std::int32_t type) {
    if (type != HS_CONTACT_NONE && std::find(types.begin(), types.end(), type) == types.end())
      types.push_back(type);
  }
};

TEST_CASE("A4.2a a block falls on its corner, then its edge, then its face, and rests") {
  const double stiffness = 2e10, time_step = 1e-5;
  hs_law_def law = spring_law(stiffness, friction);
  // The paper names no damping; without any a block comes to rest by friction alone, and slowly.
  law.normal_damping = law.shear_damping = 0.1;
  SolidScene scene(solid_world_def(time_step), law, density);
  scene.add_hull(cuboid({10, 10, 1}), {{0, 0, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED});
  const Quaternion askew = after(turn_about({0, 1, 0}, 0.2), turn_about({1, 0, 0}, 0.35));
  const hs_block block = scene.add_hull(cuboid({1, 1, 1}), {{0, 0, 1}, askew});
  TypesInOrder seen;
  for (int i = 0; i < 400000; ++i) {
    scene.step();
    seen.note(scene.contact_type());
  }
  std::printf("A4.2a contact types in order:");
  for (const std::int32_t type : seen.types) std::printf(" %s", name_of_type(type));
  const double rest = scene.place_of(block)[2] - 0.5;
  const double overlap = density * 9.81 / stiffness;
  std::printf("; at 4 s speed %.1e m/s, overlap %.6e m, weight over stiffness %.6e m\n",
              scene.speed_of(block, 1), -rest, overlap);
  REQUIRE(seen.types.size() >= 3);
  CHECK(seen.types[0] == HS_CONTACT_VERTEX_FACE);
  CHECK(seen.types[1] == HS_CONTACT_EDGE_FACE);
  CHECK(seen.types[2] == HS_CONTACT_FACE_FACE);
  CHECK(scene.contact_type() == HS_CONTACT_FACE_FACE);
  CHECK(scene.speed_of(block, 1) < 1e-9);
  // Rounding of the height against an overlap of 1e-6 of it.
  CHECK(-rest == Approx(overlap).epsilon(1e-9));
}

/// What an edge that falls on one across it does.
struct Bounce {
  std::vector<std::int32_t> types;  // before it came off
  hs_block_state off;               // as it came off
  hs_block_state later;             // 1 s after
};

constexpr double drop = 0.1;
constexpr double beside = 0.3;  // of the centroid, from the ridge

/// The ridge of the lower block lies along y at height 0; the lower edge of the other one along x.
Bounce bounce(double friction_angle) {
  SolidScene scene(solid_world_def(1e-6), spring_law(2e11, friction_angle), density);
  const double half_diagonal = std::sqrt(0.5);
  scene.add_hull(cuboid({1, 1, 1}), {{0, 0, -half_diagonal}, turn_about({0, 1, 0}, pi / 4), HS_BLOCK_FIXED});
  const hs_block block =
      scene.add_hull(cuboid({1, 1, 1}), {{beside, 0, half_diagonal + drop}, turn_about({1, 0, 0}, pi / 4)});
  TypesInOrder seen;
  std::int32_t type = HS_CONTACT_NONE;
  for (int i = 0; i < 300000 && (seen.types.empty() || type != HS_CONTACT_NONE); ++i) {
    scene.step();
    type = scene.contact_type();
    seen.note(type);
  }
  Bounce result{seen.types, scene.state(block), {}};
  scene.step(1000000);
  result.later = scene.state(block);
  return result;
}

TEST_CASE("A4.2b a block falls on an edge across its own, bounces off and falls on") {
  const double speed = std::sqrt(2 * 9.81 * drop);
  const Bounce rough = bounce(friction), smooth = bounce(0);
  // Elastic and without friction: an impulse J upwards, `beside` the centroid, of a cube with I = m/6:
  // J = 2 m v / (1 + m beside^2 / I).
  const double impulse = 2 * speed / (1 + 6 * square_of(beside));
  std::printf(
      "A4.2b falls at %.4f m/s, bounces off %s at %.4f m/s with a spin of %.4f /s; without friction at "
      "%.6f with %.6f, by the impulse at %.6f with %.6f\n",
      speed, name_of_type(rough.types[0]), rough.off.velocity[2], rough.off.angular_velocity[1],
      smooth.off.velocity[2], smooth.off.angular_velocity[1], impulse - speed, 6 * beside * impulse);
  for (const Bounce& b : {rough, smooth}) {
    CHECK(b.types == std::vector<std::int32_t>{HS_CONTACT_EDGE_EDGE});
    CHECK(b.off.velocity[2] > 0);
    // Beside the ridge.
    CHECK(b.later.pose.position[2] < 0);
    CHECK(b.later.velocity[2] < 0);
  }
  // While they touch, for t = pi sqrt(m / (K (1 + m beside^2 / I))) = 0.3 ms, the weight adds g t = 3e-3 m/s,
  // the block turns by at most spin t = 6e-4 rad, which changes the arm by 0.7 times that: 1e-3 of it.
  CHECK(smooth.off.velocity[2] == Approx(impulse - speed).margin(4e-3));
  CHECK(smooth.off.angular_velocity[1] == Approx(6 * beside * impulse).epsilon(4e-3));
}

}  // namespace
