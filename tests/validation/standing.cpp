// A block that friction can hold stands under the damping that laws have by default, although gravity loads
// it at once.

#include "catch.h"
#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;

constexpr double tangent_of_slope = 0.5;
constexpr double weight = 9.81;

hs_law_def default_law(int32_t kind, double friction) {
  hs_law_def law;
  hs_law_def_init(&law, sizeof law);
  law.stiffness_kind = kind;
  law.normal_stiffness = 1e8;
  law.friction_angle = std::atan(friction);
  return law;
}

/// A slope that lies level, and so gravity is turned.
hs_world_def on_slope(int dimension) {
  hs_world_def def;
  hs_world_def_init(&def, sizeof def, dimension);
  const double cosine = 1 / std::hypot(1, tangent_of_slope);
  for (double& g : def.gravity) g = 0;
  def.gravity[0] = weight * cosine * tangent_of_slope;
  def.gravity[dimension - 1] = -weight * cosine;
  def.potential_length = 1;
  return def;
}

struct Rest {
  double slid;     // in the last second of four
  double fastest;  // in that second
  bool hopped;     // was without contact, ever
};

template <class AnyScene>
Rest rest_of(AnyScene& scene, hs_block block) {
  const double step = scene.report().time_step;
  Rest rest{};
  double start = 0;
  for (double time = 0; time < 4; time += step) {
    scene.step();
    rest.hopped |= scene.report().contact_count == 0;
    if (time < 3) {
      start = scene.position(block).x;
    } else {
      rest.fastest = std::max(rest.fastest, std::hypot(scene.velocity(block).x, scene.velocity(block).y));
    }
  }
  rest.slid = scene.position(block).x - start;
  return rest;
}

}  // namespace

TEST_CASE("blocks stand on a slope under every law, with no more said than stiffness and friction") {
  for (const int32_t kind : all_stiffness_kinds) {
    double slid = 0, fastest = 0;
    for (const double height : {0.25, 0.5, 1.0}) {
      for (const double friction : {0.51, 0.55, 0.7, 1.2}) {
        Scene plane(on_slope(2), default_law(kind, friction), 2500);
        plane.add(box(-5, -1, 5, 0), {HS_BLOCK_FIXED, {}, 0});
        const Rest in_plane = rest_of(plane, plane.add(box(-0.5, 0, 0.5, height)));

        SolidScene space(on_slope(3), default_law(kind, friction), 2500);
        space.add_hull(cuboid({10, 10, 1}), {{0, 0, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED});
        const Rest in_space = rest_of(space, space.add_hull(cuboid({1, 1, height}), {{0, 0, height / 2}}));

        for (const Rest& rest : {in_plane, in_space}) {
          CHECK_FALSE(rest.hopped);
          slid = std::max(slid, std::abs(rest.slid));
          fastest = std::max(fastest, rest.fastest);
        }
      }
    }
    std::printf("standing on tan 0.5, %s: in the fourth second moved by %.1e m at most, speed %.1e m/s\n",
                name_of_stiffness(kind), slid, fastest);
    // Without damping it is 4 cm per contact, and over half a metre, hopping, under the other laws.
    CHECK(slid < 1e-4);
    CHECK(fastest < 1e-3);
  }
}

TEST_CASE("a law that says no shear stiffness has that of its normal springs") {
  hs_law_def law = default_law(HS_STIFFNESS_PER_CONTACT, 0.7);
  double forces[2];
  for (const bool is_said : {false, true}) {
    law.shear_stiffness = is_said ? law.normal_stiffness : 0;
    Scene scene(on_slope(2), law, 2500);
    scene.add(box(-5, -1, 5, 0), {HS_BLOCK_FIXED, {}, 0});
    scene.add(box(-0.5, -1e-3, 0.5, 1 - 1e-3));
    scene.step(10);
    forces[is_said] = scene.contacts()[0].shear_force[0];
  }
  CHECK(forces[0] != 0);
  CHECK(forces[0] == forces[1]);
}
