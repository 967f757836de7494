// Potentials in compounds, against one convex block. Each part of a compound has its own potential, which is
// 0 on its inner faces, too. A block that lies over such a face to the depth d loses two triangles of d x d,
// one on either side: the force k d^2 and the energy k d^3 / 3, for H = 1 m.

#include <cstdio>

#include "catch.h"
#include "validation/compound_scene.h"

namespace {

using namespace halfspace_test;

constexpr double no_gravity = 0;
constexpr double mass = CompoundScene::density;  // of a square or cube
constexpr double rounding = 1.1102230246251565e-16;

const Bricks one_plate = {{{-4, -2}, {4, 0}}}, two_plates = {{{-4, -2}, {0, 0}}, {{0, -2}, {4, 0}}};
const Bricks square = {{{-0.5, 0}, {0.5, 1}}}, halves = {{{-0.5, 0}, {0, 1}}, {{0, 0}, {0.5, 1}}};

hs_law_def potential_law(double stiffness, double friction_angle = 0) {
  hs_law_def law = area_law(stiffness, friction_angle);
  law.stiffness_kind = HS_STIFFNESS_POTENTIAL;
  return law;
}

hs_world_def definition(int dimension, double time_step, double along_y) {
  hs_world_def def = CompoundScene::definition(dimension, time_step, along_y);
  def.potential_length = 1;
  return def;
}

/// A block on a fixed one, each a compound where it has two bricks.
struct OnPlate {
  CompoundScene scene;
  hs_block block = 0;

  OnPlate(int dimension, const hs_law_def& law, const hs_world_def& def, const Bricks& plate,
          const Bricks& bricks, Point moved, Point velocity = {})
      : scene(dimension, law, def) {
    const auto add = [&](const Bricks& b, Point by, Point speed, std::int32_t kind) {
      return b.size() == 1 ? scene.add_one(b[0], by, speed, {}, kind) : scene.add(b, by, speed, {}, kind);
    };
    add(plate, {}, {}, HS_BLOCK_FIXED);
    block = add(bricks, moved, velocity, HS_BLOCK_RIGID);
  }
  hs_block_state state() const { return scene.state(block); }
};

/// In space both blocks are as wide across, and flush: a point above the inner face at the depth y is nearer
/// to a flank within y of either end. So a triangle becomes a wedge whose length falls by 2 y.
double lost_force(int dimension, double depth) {
  return depth * depth - (dimension == 3 ? 4.0 / 3 * depth * depth * depth : 0);
}

/// Twice the base, without the cells of the block's two ends. In space also without those of both flanks.
double force_on_one_plate(int dimension, double depth) {
  if (dimension == 2) return 2 * depth - depth * depth;
  return 2 * depth - 3 * depth * depth + 4.0 / 3 * depth * depth * depth;
}

double kinetic(const hs_block_state& state) {
  const auto square_of = [](double x) { return x * x; };
  return 0.5 * mass * (square_of(state.velocity[0]) + square_of(state.velocity[1])) +
         0.5 * mass / 6 * square_of(state.angular_velocity[2]);
}

/// A block that slides over the inner face, and the same on one plate. It starts at rest on its law, and its
/// front 0.1 m before the inner face.
struct Crossing {
  double stiffness;
  int dimension;
  double depth;
  OnPlate one;
  OnPlate two;

  Crossing(int dimension, const hs_law_def& law, double speed)
      : stiffness(law.normal_stiffness),
        dimension(dimension),
        depth(rest_depth(dimension, law.normal_stiffness)),
        one(sliding(law, speed, one_plate)),
        two(sliding(law, speed, two_plates)) {}

  /// By Newton's method.
  static double rest_depth(int dimension, double stiffness) {
    const double wanted = mass * gravity / stiffness;
    double depth = wanted / 2;
    for (int i = 0; i < 20; ++i) depth -= (force_on_one_plate(dimension, depth) - wanted) / 2;
    return depth;
  }
  OnPlate sliding(const hs_law_def& law, double speed, const Bricks& plate) const {
    return OnPlate(dimension, law, definition(dimension, time_step, -gravity), plate, square, {-0.6, -depth},
                   {speed, 0});
  }
  void go(double time) {
    one.scene.step(std::llround(time / time_step));
    two.scene.step(std::llround(time / time_step));
  }
  /// The energy of the motion along, more than on one plate.
  double gained() const {
    const double fast = two.state().velocity[0], slow = one.state().velocity[0];
    return 0.5 * mass * (fast * fast - slow * slow);
  }
  double well() const { return stiffness * depth * depth * depth / 3 * (dimension == 3 ? 1 - depth : 1); }
  /// The change k d^2 of the push, let go at once, lifts and tilts the block, which then swings with up to
  /// four times the energy that it has at rest: F^2 / (2 K) as it is lifted and three times that as it is
  /// tilted by its end. All of it when it comes and again when it leaves.
  double swing() const {
    const double push = stiffness * depth * depth, lift = push / (2 * stiffness);
    return 2 * 4 * (1 + 3) * push * lift / 2;
  }
  static constexpr double time_step = 5e-5;
};

}  // namespace

/// Forces are sums of some ten cells, each rounded a few times.
TEST_CASE("by potentials an inner face takes two triangles off the force on a block over it", "[compound]") {
  const int dimension = GENERATE(2, 3);
  constexpr double stiffness = 1e8;
  const double depth = GENERATE(1e-4, 1e-2, 0.1), place = GENERATE(0.0, 0.17, -0.3);
  const auto force = [&](const Bricks& plate, const Bricks& bricks) {
    OnPlate pressed(dimension, potential_law(stiffness), definition(dimension, 1e-5, no_gravity), plate,
                    bricks, {place, -depth});
    pressed.scene.step(0);
    return pressed.state();
  };
  const double whole = force_on_one_plate(dimension, depth), lost = lost_force(dimension, depth);
  const double error = 64 * rounding * stiffness;  // of coordinates up to 4 m
  const auto check = [&](const Bricks& plate, const Bricks& bricks, int inner_faces, double turning) {
    const hs_block_state found = force(plate, bricks);
    CHECK(std::abs(found.force[1] - stiffness * (whole - inner_faces * lost)) <= error);
    CHECK(std::abs(found.force[0]) <= error);
    CHECK(std::abs(found.torque[2] - stiffness * lost * turning) <= error);
  };
  check(one_plate, square, 0, 0);
  check(two_plates, square, 1, place);  // the force that is missing at x = 0 turns the block
  check(one_plate, halves, 1, 0);
  // The plate's potential loses at its inner face, and that of the halves at theirs.
  check(two_plates, halves, 2, place);
}

/// The energy that is missing draws the block over the inner face: the pull is k (d - |s|)^2 / 2 where its
/// end is s away from the face.
TEST_CASE("by potentials an inner face draws a block over it, and stops none", "[compound]") {
  constexpr double stiffness = 1e8, depth = 1e-2;
  for (const double away : {-1.5, -0.6, -0.2, 0.0, 0.3, 0.8, 1.2}) {
    OnPlate pressed(2, potential_law(stiffness), definition(2, 1e-5, no_gravity), two_plates, square,
                    {-0.5 + away * depth, -depth});
    pressed.scene.step(0);
    const double inside = std::max(0.0, depth - std::abs(away) * depth);
    CHECK(std::abs(pressed.state().force[0] - stiffness * inside * inside / 2) <= 64 * rounding * stiffness);
  }
}

/// Without gravity the depth d stores k (d^2 - c d^3 / 3): c is 1 on one plate and 2 over an inner face. The
/// force k d^2 that is missing there turns a block whose middle is beside it. With d = D sin(w t) and the
/// tilt held by half of w^2, the spin after half a period is that of the moment alone, times the share below,
/// but for corrections of up to 3 D to the stiffness of the tilt, its moment and its inertia.
TEST_CASE("by potentials a block bounces off two parts as off one, but for the force of the inner face",
          "[compound]") {
  constexpr double stiffness = 1e8, speed = 0.1, time_step = 2e-6, energy = 0.5 * mass * speed * speed;
  const double place = GENERATE(0.0, 0.2);
  const bool has_joint = GENERATE(false, true);
  const double frequency = std::sqrt(2 * stiffness / mass), first_depth = speed / frequency;
  const double of_step = frequency * time_step * frequency * time_step;
  OnPlate thrown(2, potential_law(stiffness), definition(2, time_step, no_gravity),
                 has_joint ? two_plates : one_plate, square, {place, 1e-4}, {0, -speed});
  double deepest = 0;
  do {
    thrown.scene.step(1);
    deepest = std::max(deepest, 0.5 - thrown.state().pose.position[1]);
  } while (thrown.state().velocity[1] < 0 || thrown.state().pose.position[1] < 0.5 + 1e-4);
  double depth = first_depth;
  for (int i = 0; i < 20; ++i) depth = first_depth / std::sqrt(1 - (has_joint ? 2 : 1) * depth / 3);
  const double root = std::sqrt(0.5), share = 4 / pi * std::sin(pi * root) / (root * 3.5);
  const double moment = stiffness * first_depth * first_depth * place, inertia = mass / 6;
  const double spin = has_joint ? share * 0.5 * pi / frequency * moment / inertia : 0;
  const hs_block_state after = thrown.state();
  std::printf(
      "%d parts, middle %.1f beside: depth %.6g of %.6g m, energy %.7g of %.0f J, spin %.4g of %.4g\n",
      has_joint ? 2 : 1, place, deepest, depth, kinetic(after), energy, after.angular_velocity[2], spin);
  CHECK(std::abs(deepest / depth - 1) <= of_step);
  CHECK(std::abs(kinetic(after) / energy - 1) <= of_step);
  CHECK(std::abs(after.angular_velocity[2] - spin) <= 3 * 3 * first_depth * spin + 1e-10);
}

/// With its weight on the depth d, a block slides over the inner face without friction. It gains the energy
/// k d^3 / 3 as it comes over it, and gives it back as it leaves.
TEST_CASE("by potentials a block slides over an inner face and has its speed again behind it", "[compound]") {
  const int dimension = GENERATE(2, 3);
  Crossing crossing(dimension, potential_law(1e7), 1);
  crossing.go(0.6);  // the middle of the block is over the inner face
  const double over = crossing.gained();
  crossing.go(0.6);  // and all of it is behind
  std::printf("%dD: over the inner face %.4g J faster, expected %.4g J; behind it %.1e J, at most %.1e J\n",
              dimension, over, crossing.well(), crossing.gained(), crossing.swing());
  CHECK(std::abs(over - crossing.well()) <= crossing.swing());
  CHECK(std::abs(crossing.gained()) <= crossing.swing());
}

/// The front of a block that friction tilts is deeper, by up to twice the static tilt. It lets friction miss
/// twice the push on a way of twice that depth, and makes it swing with the push for half a period.
TEST_CASE("by potentials friction takes over an inner face what it takes on one plate", "[compound]") {
  const int dimension = GENERATE(2, 3);
  constexpr double friction = 5 * degree, stiffness = 1e7;
  const double coefficient = std::tan(friction);
  Crossing crossing(dimension, potential_law(stiffness, friction), 3);
  crossing.go(0.4);
  const double front = (1 + 2 * 3 * coefficient) * crossing.depth, push = stiffness * front * front;
  const double half_swing = 3 * pi / std::sqrt(2 * stiffness / mass);
  const double most =
      coefficient * push * (2 * 2 * front + 2 * half_swing) + crossing.well() + crossing.swing();
  std::printf("%dD: friction takes %.2g J more over the inner face of %.0f J, at most %.2g J\n", dimension,
              -crossing.gained(), 0.5 * mass * 9 - kinetic(crossing.one.state()), most);
  CHECK(std::abs(crossing.gained()) <= most);
}

/// The line of action of a front that is less than d past the inner face lies along the motion, and leans to
/// it by 1 / (2 s - 1) when it is s d past. There a dashpot acts against the speed: with the viscosity c of a
/// contact as wide as the depth, times the root of 1.5 for s < 1, and of s behind. Together 1.72 c v d.
TEST_CASE("by potentials an inner face takes the work of a dashpot on a way of the depth", "[compound]") {
  constexpr double stiffness = 1e7, damping = 0.3, speed = 1;
  hs_law_def law = potential_law(stiffness);
  law.normal_damping = damping;
  Crossing crossing(2, law, speed);
  crossing.go(0.6);
  const double viscosity = 2 * damping * std::sqrt(mass * 2 * stiffness * crossing.depth);
  const double most = 1.72 * viscosity * speed * crossing.depth;
  std::printf("a dashpot takes %.3g J at the inner face, at most %.3g J\n", -crossing.gained(), most);
  CHECK(-crossing.gained() <= most + crossing.swing());
  CHECK(-crossing.gained() > most / 2);
}
