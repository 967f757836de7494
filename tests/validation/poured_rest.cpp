// What is poured comes to rest, with nothing said but stiffness, density and friction.

#include "catch.h"
#include "validation/random_bodies.h"

namespace {

using namespace halfspace_test;

constexpr double at_rest = 1e-3;  // m/s, of the fastest block

/// Lets random blocks of some 1 m fall into a bin until they are at rest. Prints how long it took and what
/// became of the energy.
void check_comes_to_rest(int dimension, int32_t stiffness_kind, int across, int layers, double most_time) {
  Random random(3);
  const Bodies bodies = loose(dimension, across, layers, random);
  hs_law_def law = stiffness_kind == HS_STIFFNESS_POTENTIAL ? potential_law(1e8, 30 * degree, 1e8)
                                                            : spring_law(1e8, 30 * degree);
  hs_law_def defaults;
  hs_law_def_init(&defaults, sizeof defaults);
  law.stiffness_kind = stiffness_kind;
  law.normal_damping = defaults.normal_damping;
  law.shear_damping = defaults.shear_damping;
  const hs_world_def def = dimension == 3 ? solid_world_def(0) : world_def(0);
  BodyScene scene(dimension, def, law, bodies);
  hs_world_report report = scene.report();
  do {
    scene.step(200);
    report = scene.report();
  } while (report.largest_speed > at_rest && report.time < most_time);
  const hs_energy& energy = report.energy;
  std::printf(
      "poured in %dD, %s, %d blocks: fastest %.1e m/s after %.1f s, residual %.2f %% of what was lost\n",
      dimension, name_of_stiffness(stiffness_kind), int(bodies.size()), report.largest_speed, report.time,
      100 * energy.residual / (energy.friction_loss + energy.contact_damping_loss));
  CHECK(report.largest_speed <= at_rest);
}

TEST_CASE("what is poured comes to rest") {
  for (const int32_t kind : all_stiffness_kinds) {
    check_comes_to_rest(2, kind, 8, 8, 30);
    check_comes_to_rest(3, kind, 4, 4, 30);
  }
}

TEST_CASE("a thousand blocks that are poured come to rest", "[.][thousand]") {
  for (const int32_t kind : all_stiffness_kinds) {
    check_comes_to_rest(2, kind, 25, 40, 60);
    check_comes_to_rest(3, kind, 10, 10, 60);
  }
}

}  // namespace
