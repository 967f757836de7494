// Friction takes energy and never gives any: a spring along the contact plane whose area shrinks gives back
// no more than it took.

#include "catch.h"
#include "validation/random_bodies.h"

namespace {

using namespace halfspace_test;

hs_law_def rough_law(int32_t kind, double friction) {
  hs_law_def law = spring_law(3e7, std::atan(friction));
  law.stiffness_kind = kind;
  return law;
}

/// A square, or a cube, that strikes a plate on a corner, at 1 m/s.
struct Strike {
  double energy;  // afterwards, over that before
  double least_loss;
};

Strike strike(int dimension, int32_t kind, double friction, double angle, double turn) {
  hs_world_def def = solid_world_def(0, {0, 0, 0});
  def.dimension = dimension;
  def.safety = 0.1;
  def.potential_length = 0.1;
  SolidScene scene(def, rough_law(kind, friction), 1000);
  const double down[3] = {std::sin(angle), dimension == 2 ? -std::cos(angle) : 0,
                          dimension == 2 ? 0 : -std::cos(angle)};
  if (dimension == 2) {
    scene.add(box(-10, -1, 10, 0), {HS_BLOCK_FIXED, {}, 0});
    scene.add_at(box(-0.05, -0.05, 0.05, 0.05), {0, 0.0708}, turn, {HS_BLOCK_RIGID, {down[0], down[1]}, 0});
  } else {
    scene.add_hull(cuboid({20, 20, 1}), {{0, 0, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED});
    SolidStart start{{0, 0, 0.087}, turn_about({1, 0.7, 0.2}, turn)};
    start.velocity = {down[0], down[1], down[2]};
    scene.add_hull(cuboid({0.1, 0.1, 0.1}), start);
  }
  const double first = scene.energy().kinetic;
  double before = 0, least = 0;
  // A block that turns may strike again: its energy is kinetic alone when it has left.
  while (scene.report().time < 0.08 || (scene.report().contact_count > 0 && scene.report().time < 1)) {
    scene.step();
    const double loss = scene.energy().friction_loss;
    least = std::min(least, (loss - before) / first);
    before = loss;
  }
  REQUIRE(scene.report().contact_count == 0);
  return {scene.energy().kinetic / first, least};
}

}  // namespace

TEST_CASE("a rough collision makes no energy, by any law with springs") {
  for (const int dimension : {2, 3}) {
    for (const int32_t kind : all_stiffness_kinds) {
      Random random(5);
      double most = 0, least_loss = 0;
      for (int round = 0; round < 12; ++round) {
        const Strike one =
            strike(dimension, kind, random.uniform(0.1, 1), random.uniform(0, 1.2), random.uniform(0.1, 1.4));
        most = std::max(most, one.energy);
        least_loss = std::min(least_loss, one.least_loss);
      }
      std::printf(
          "rough collision in %dD, %s: leaves with %.6f of its energy at most, least loss of a step %.1e\n",
          dimension, name_of_stiffness(kind), most, least_loss);
      CHECK(most < 1 + 1e-4);
    }
  }
}
