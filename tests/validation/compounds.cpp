// Compounds: concave blocks of convex parts, against the theory of rigid bodies and against one convex block.

#include <cstdio>

#include "catch.h"
#include "validation/compound_scene.h"

namespace {

using namespace halfspace_test;

constexpr Brick square{{0, 0}, {1, 1}};
const Bricks halves = {{{0, 0}, {0.5, 1}}, {{0.5, 0}, {1, 1}}};

}  // namespace

TEST_CASE("an L falls and spins as a rigid body does", "[compound]") {
  const int dimension = GENERATE(2, 3);
  constexpr double step = 1e-3, spin = 3;
  constexpr int steps = 1000;
  CompoundScene scene(dimension, area_law(1e8), step);
  const hs_block block = scene.add(l_shape(), {2, 5}, {1, 4}, {0, 0, spin});
  scene.step(steps);
  const hs_block_state now = scene.state(block);
  const double time = steps * step, mass = 4 * CompoundScene::density;
  CHECK(now.mass == Approx(mass).epsilon(1e-15));
  CHECK(now.pose.position[0] == Approx(1.25 + 2 + time).epsilon(1e-12));
  CHECK(now.pose.position[1] == Approx(0.75 + 5 + 4 * time - 0.5 * gravity * time * time).epsilon(1e-12));
  CHECK(now.angular_velocity[2] == Approx(spin).epsilon(1e-12));
  if (dimension == 2) CHECK(now.angle == Approx(spin * time).epsilon(1e-12));
  // About the centroid: 3 (9 + 1) / 12 + 3 (0.25^2 + 0.25^2), and 2 / 12 + 0.75^2 + 0.75^2.
  const double inertia = CompoundScene::density * (2.5 + 0.375 + 1.0 / 6 + 1.125);
  const double speed_square = 1 + (4 - gravity * time) * (4 - gravity * time);
  CHECK(scene.report().energy.kinetic ==
        Approx(0.5 * mass * speed_square + 0.5 * inertia * spin * spin).epsilon(1e-12));
  // Its parts follow.
  const auto parts = scene.parts(block);
  REQUIRE(parts.size() == 2);
  const double angle = spin * time, c = std::cos(angle), s = std::sin(angle);
  const hs_block_state part = scene.state(parts[1]);
  const double arm[2] = {-0.75 * c - 0.75 * s, -0.75 * s + 0.75 * c};
  for (int k = 0; k < 2; ++k)
    CHECK(part.pose.position[k] == Approx(now.pose.position[k] + arm[k]).epsilon(1e-12));
  CHECK(part.velocity[0] == Approx(now.velocity[0] - spin * arm[1]).epsilon(1e-12));
  CHECK(part.velocity[1] == Approx(now.velocity[1] + spin * arm[0]).epsilon(1e-12));
  CHECK(part.mass == 0);
  CHECK(scene.report().contact_count == 0);  // parts do not touch each other
}

TEST_CASE("two halves tumble as the one block does", "[compound]") {
  const int dimension = GENERATE(2, 3);
  CompoundScene of_parts(dimension, area_law(1e8), 1e-3), of_one(dimension, area_law(1e8), 1e-3);
  const std::array<double, 3> spin = {1, 2, 3};
  const Bricks parts = {{{0, 0}, {0.8, 1.5}}, {{0.8, 0}, {2, 1.5}}};
  const hs_block block = of_parts.add(parts, {}, {}, spin);
  const hs_block one = of_one.add_one({{0, 0}, {2, 1.5}}, {}, {}, spin);
  of_parts.step(2000);
  of_one.step(2000);
  CHECK(apart(of_parts.state(block), of_one.state(one)) < 1e-11);
  CHECK(of_parts.report().energy.kinetic == Approx(of_one.report().energy.kinetic).epsilon(1e-12));
}

TEST_CASE("the time step of a compound is that of the block with its mass", "[compound]") {
  const int dimension = GENERATE(2, 3);
  for (const hs_law_def& law : {area_law(1e8), law_def(1e8, 0.5), damped(law_def(1e8, 0))}) {
    CompoundScene of_parts(dimension, law, 0), of_one(dimension, law, 0);
    of_parts.add(halves);
    of_one.add_one(square);
    CHECK(of_parts.report().stable_time_step == Approx(of_one.report().stable_time_step).epsilon(1e-12));
  }
}

/// They do where the forces of two contacts are those of one: as long as none of them slides or parts.
/// The floor presses on the inner sides of the halves, too: that turns their forces, and with them their
/// shear springs, by the sink over the length, and may change the frequency of a swing by that part.
TEST_CASE("two halves bounce and swing on the floor as the one square does", "[compound]") {
  const int dimension = GENERATE(2, 3);
  const bool bounces = GENERATE(true, false);
  const hs_law_def law = area_law(1e8, bounces ? 0 : 60 * degree);
  CompoundScene of_parts(dimension, law, 1e-4), of_one(dimension, law, 1e-4);
  const double sink = CompoundScene::density * gravity / 1e8;
  const Point moved{0, bounces ? 0.1 : -sink}, velocity{bounces ? 1 : 1e-3, 0};
  constexpr double time = 1;  // of all steps
  of_parts.add_floor();
  of_one.add_floor();
  const hs_block block = of_parts.add(halves, moved, velocity);
  const hs_block one = of_one.add_one(square, moved, velocity);
  double most = 0;
  for (int i = 0; i < 100; ++i) {
    of_parts.step(100);
    of_one.step(100);
    most = std::max(most, apart(of_parts.state(block), of_one.state(one)));
  }
  std::printf("%dD: halves that %s differ from the square by %.1e\n", dimension, bounces ? "bounce" : "swing",
              most);
  CHECK(most < (bounces ? 1e-9 : sink * velocity.x * time));
}

TEST_CASE("two halves slide as far as friction lets them", "[compound]") {
  const int dimension = GENERATE(2, 3);
  const bool has_springs = GENERATE(true, false);
  constexpr double friction = 20 * degree, speed = 2;
  CompoundScene scene(dimension, has_springs ? damped(area_law(1e8, friction)) : no_spring(friction),
                      has_springs ? 1e-4 : 1e-3);
  scene.add_floor();
  const double sink = has_springs ? CompoundScene::density * gravity / 1e8 : 0;
  const hs_block block = scene.add(halves, {0, -sink}, {speed, 0});
  scene.step(has_springs ? 10000 : 1000);
  const double way = speed * speed / (2 * gravity * std::tan(friction));
  const double slid = scene.state(block).pose.position[0] - 0.5;
  std::printf("%dD %s: halves slide %.6f m of %.6f\n", dimension, has_springs ? "springs" : "no springs",
              slid, way);
  CHECK(slid == Approx(way).epsilon(2e-3));
}

/// The gate on springs of one stiffness per area is a rigid foundation on Winkler's bed.
TEST_CASE("the feet of a gate bear what statics says", "[compound]") {
  const int dimension = GENERATE(2, 3);
  const bool has_springs = GENERATE(true, false);
  // Feet about x = 0.5 and 3.5, a beam, and a load over the left foot.
  const Bricks gate = {{{0, 0}, {1, 1}}, {{3, 0}, {4, 1}}, {{0, 1}, {4, 2}}, {{0, 2}, {1, 3}}};
  constexpr double volume = 7, centroid = (0.5 + 3.5 + 4 * 2 + 0.5) / volume;
  CompoundScene scene(dimension, has_springs ? damped(area_law(1e11, 0.5)) : no_spring(0.5),
                      has_springs ? 0 : 1e-3);
  scene.add_floor();
  const hs_block block = scene.add(gate);
  if (has_springs) {
    hs_relaxation_def relaxation;
    REQUIRE(hs_relaxation_def_init(&relaxation, sizeof relaxation) == HS_OK);
    relaxation.ratio = 1e-7;
    require_ok(hs_world_relax(scene.world.get(), &relaxation, nullptr, 0), scene.context.get());
  } else {
    scene.step(10);
  }
  const double weight = volume * CompoundScene::density * gravity;
  const auto parts = scene.parts(block);
  double of_foot[2] = {}, moment = 0;
  for (const hs_contact& contact : contacts_of(scene.world.get())) {
    for (std::size_t foot = 0; foot < 2; ++foot) {
      if (contact.block_b == parts[foot]) of_foot[foot] += contact.force[1] / weight;
    }
    moment += contact.force[1] / weight * contact.force_point[0];
  }
  std::printf("%dD %s: feet bear %.9f and %.9f of the weight, about %.9f of %.9f m\n", dimension,
              has_springs ? "springs" : "no springs", of_foot[0], of_foot[1], moment, centroid);
  CHECK(of_foot[0] + of_foot[1] == Approx(1).epsilon(1e-6));
  CHECK(moment == Approx(centroid).epsilon(1e-6));
  if (!has_springs) return;
  // p = d + t x over both feet, with sums 2 d + 4 t = 1 and 4 d + 38/3 t = the centroid.
  const double turn = (centroid - 2) / (38.0 / 3 - 8), depth = 0.5 - 2 * turn;
  CHECK(of_foot[0] == Approx(depth + 0.5 * turn).epsilon(1e-5));
  CHECK(of_foot[1] == Approx(depth + 3.5 * turn).epsilon(1e-5));
}

TEST_CASE("an overhang tips where its centroid passes the foot's end", "[compound]") {
  const int dimension = GENERATE(2, 3);
  const double beyond = GENERATE(-1.0, 1.0);
  const bool has_springs = GENERATE(true, false);
  // A column of 1 x 3 with an arm 1 high: 1.5 + a + a^2/2 = 3 + a. Springs give way near the foot's end.
  const double arm = std::sqrt(3.0) + beyond * (has_springs ? 5e-2 : 1e-4);
  CompoundScene scene(dimension, has_springs ? damped(area_law(1e12, 40 * degree)) : no_spring(40 * degree),
                      has_springs ? 0 : 2e-3);
  scene.add_floor();
  const hs_block block = scene.add({{{0, 0}, {1, 3}}, {{1, 2}, {1 + arm, 3}}});
  run(scene.context.get(), scene.world.get(), has_springs ? 2 : 8);
  const double turned = 2 * std::asin(std::abs(scene.state(block).pose.rotation[2]));
  std::printf("%dD %s: an arm of %.5f turns by %.2e\n", dimension, has_springs ? "springs" : "no springs",
              arm, turned);
  if (beyond < 0) {
    CHECK(turned < 1e-3);
  } else {
    CHECK(turned > 0.05);
  }
}

TEST_CASE("hooks that collide keep momentum, angular momentum and energy", "[compound]") {
  const int dimension = GENERATE(2, 3);
  CompoundScene scene(dimension, area_law(1e8), 1e-5, 0);
  const double spins[2] = {0.7, -1.1};
  const hs_block blocks[2] = {scene.add(l_shape(), {0, 0}, {1, 0.3}, {0, 0, spins[0]}),
                              scene.add(l_shape(), {3.5, 0.4}, {-2, 0}, {0, 0, spins[1]})};
  const double inertia = CompoundScene::density * (2.5 + 0.375 + 1.0 / 6 + 1.125);
  const auto momenta = [&] {
    std::array<double, 3> sum{};
    for (const hs_block block : blocks) {
      const hs_block_state s = scene.state(block);
      sum[0] += s.mass * s.velocity[0];
      sum[1] += s.mass * s.velocity[1];
      sum[2] += s.mass * (s.pose.position[0] * s.velocity[1] - s.pose.position[1] * s.velocity[0]) +
                inertia * s.angular_velocity[2];
    }
    return sum;
  };
  const auto before = momenta();
  const double energy = scene.report().energy.kinetic;
  bool has_touched = false;
  double most = 0, energy_off = 0;
  for (int i = 0; i < 400; ++i) {
    scene.step(250);
    has_touched = has_touched || scene.report().contact_count > 0;
    const auto now = momenta();
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(now[k] - before[k]));
    energy_off = std::max(energy_off, std::abs(scene.report().energy.residual));
  }
  std::printf("%dD: momenta off by %.1e of %.0f, energy by %.1e of %.0f\n", dimension, most,
              std::abs(before[0]), energy_off, energy);
  CHECK(has_touched);
  CHECK(most < 1e-12 * 4 * CompoundScene::density * 2 * 10 * 100);
  CHECK(energy_off < 1e-4 * energy);
}

TEST_CASE("a block slides over the joint of two parts as over one plate", "[compound]") {
  const int dimension = GENERATE(2, 3);
  constexpr double friction = 20 * degree, speed = 4;
  CompoundScene scene(dimension, damped(area_law(1e8, friction)), 1e-4);
  scene.add({{{-5, -1}, {0.8, 0}}, {{0.8, -1}, {8, 0}}}, {}, {}, {}, HS_BLOCK_FIXED);
  const double sink = CompoundScene::density * gravity / 1e8;
  const hs_block block = scene.add_one(square, {-0.5, -sink}, {speed, 0});
  scene.step(15000);
  const double way = speed * speed / (2 * gravity * std::tan(friction));
  const double slid = scene.state(block).pose.position[0];
  std::printf("%dD: slides %.6f m of %.6f over the joint\n", dimension, slid, way);
  CHECK(slid == Approx(way).epsilon(5e-3));
}
