// A block lies flush on a floor, bonded to it by the cohesion of a law, without friction and without tensile
// strength. Gravity is inclined: the joint holds while its shear stress W sin(slope) / A is below the
// cohesion, and tears where gravity pulls the faces apart.

#include "catch.h"
#include "validation/random_bodies.h"

namespace {

using namespace halfspace_test;

constexpr double density = 2000, gravity = 9.81, height = 0.5;

hs_law_def cohesive_law(std::int32_t stiffness_kind, double cohesion) {
  hs_law_def law = spring_law(1e9);
  law.stiffness_kind = stiffness_kind;
  law.cohesion = cohesion;
  law.normal_damping = law.shear_damping = 0.2;
  return law;
}

/// The gap that rounding of coordinates may leave between flush faces.
constexpr double rounding = 1e-8;

/// How far a block of unit area has moved after a second. `turn`: of the floor's normal from gravity.
Triple moved(int dimension, const hs_law_def& law, double turn) {
  const double along = gravity * std::sin(turn), down = -gravity * std::cos(turn);
  hs_world_def def = dimension == 2 ? world_def(0, down) : solid_world_def(0, {along, 0, down});
  def.gravity[0] = along;
  def.time_step = 2e-5;
  const Bodies bodies = dimension == 2
                            ? Bodies{{flat(40, 1), {0, -0.5, 0}, {0, 0, 0, 1}, HS_BLOCK_FIXED},
                                     {flat(1, height), {0, 0.5 * height + rounding, 0}}}
                            : Bodies{{cuboid({40, 40, 1}), {0, 0, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED},
                                     {cuboid({1, 1, height}), {0, 0, 0.5 * height + rounding}}};
  BodyScene scene(dimension, def, law, bodies);
  scene.step(std::int64_t(1 / def.time_step));
  const Triple start = bodies[1].position, end = scene.moved(bodies)[1].position;
  return {end[0] - start[0], end[1] - start[1], end[2] - start[2]};
}

TEST_CASE("cohesion holds a flush joint without tensile strength, up to its shear strength") {
  const double slope = 35 * degree;
  // Gravity at once makes the shear stress swing up to twice its value at rest.
  const double stress = density * gravity * height * std::sin(slope);
  for (const int dimension : {2, 3}) {
    for (const std::int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA}) {
      INFO(dimension << "D, " << name_of_stiffness(kind));
      CHECK(length(moved(dimension, cohesive_law(kind, 2.2 * stress), slope)) < 1e-4);
      const double free_way = 0.5 * gravity * std::sin(slope);
      CHECK(moved(dimension, cohesive_law(kind, 0.9 * stress), slope)[0] == Approx(free_way).epsilon(0.02));
    }
  }
}

TEST_CASE("a joint with cohesion but no tensile strength tears where gravity pulls on it") {
  for (const int dimension : {2, 3}) {
    for (const std::int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA}) {
      INFO(dimension << "D, " << name_of_stiffness(kind));
      CHECK(length(moved(dimension, cohesive_law(kind, 1e6), pi)) == Approx(0.5 * gravity).epsilon(0.02));
    }
  }
}

}  // namespace
