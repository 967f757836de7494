// What must come to rest in space does, and stays.

#include "catch.h"
#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;

constexpr double density = 2500;
constexpr double golden = 1.6180339887498949;

TEST_CASE("a stack of ten cubes rests for 10 s without creep") {
  const double stiffness = 1e8;
  hs_law_def law = spring_law(stiffness, 30 * degree);
  law.normal_damping = law.shear_damping = 0.3;
  for (const int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA}) {
    law.stiffness_kind = kind;
    SolidScene scene(solid_world_def(0), law, density);
    scene.add_hull(cuboid({20, 20, 1}), {{0, 0, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED});
    // Each starts where its springs bear what lies on it.
    std::vector<hs_block> cubes;
    std::vector<Triple> start;
    double height = 0;
    for (int i = 0; i < 10; ++i) {
      height += 1 - (10 - i) * density * 9.81 / stiffness;
      start.push_back({0, 0, height - 0.5});
      cubes.push_back(scene.add_hull(cuboid({1, 1, 1}), {start.back()}));
    }
    while (scene.report().time < 10) scene.step(1000);
    double creep = 0, speed = 0;
    for (std::size_t i = 0; i < cubes.size(); ++i) {
      creep = std::max(creep, length(scene.place_of(cubes[i]) - start[i]));
      speed = std::max(speed, scene.speed_of(cubes[i], 1));
    }
    std::printf("stack of 10 cubes, %s: after 10 s moved by %.1e m at most, speed %.1e m/s\n",
                kind == HS_STIFFNESS_PER_CONTACT ? "per contact" : "per area", creep, speed);
    // Heights of 10 m are rounded to 1e-15 m, and the overlaps with them: the forces are off by K times that,
    // 1e-7 N, and what bears ten of them settles by 10 x 10 roundings.
    CHECK(creep < 1e-13);
    CHECK(speed < 1e-10);
  }
}

struct Platonic {
  const char* name;
  Corners corners;
  double face_distance;  // of a face from the centre, for the corners given
};

std::vector<Platonic> platonic_solids() {
  Corners tetrahedron{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, octahedron, icosahedron,
      dodecahedron;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const double one : {-1.0, 1.0}) {
      Triple tip{};
      tip[k] = one;
      octahedron.push_back(tip);
      for (const double other : {-1.0, 1.0}) {
        Triple i{}, d{};
        i[k] = one;
        i[(k + 1) % 3] = other * golden;
        d[k] = one / golden;
        d[(k + 1) % 3] = other * golden;
        icosahedron.push_back(i);
        dodecahedron.push_back(d);
      }
    }
  }
  for (const Triple& corner : cuboid({2, 2, 2})) dodecahedron.push_back(corner);
  return {{"tetrahedron", tetrahedron, 1 / std::sqrt(3.0)},
          {"cube", cuboid({2, 2, 2}), 1},
          {"octahedron", octahedron, 1 / std::sqrt(3.0)},
          {"dodecahedron", dodecahedron, std::sqrt(golden * golden / (3 - golden))},
          {"icosahedron", icosahedron, golden * golden / std::sqrt(3.0)}};
}

TEST_CASE("a tumbling drop of every Platonic solid comes to rest on a face") {
  const double stiffness = 1e7;
  hs_law_def law = spring_law(stiffness, 30 * degree);
  law.normal_damping = law.shear_damping = 0.3;
  for (const Platonic& solid : platonic_solids()) {
    SolidScene scene(solid_world_def(0), law, density);
    scene.add_hull(cuboid({80, 80, 1}), {{0, 0, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED});
    SolidStart start{{0, 0, 4}, turn_about({0.3, 0.5, 0.7}, 0.9)};
    start.velocity = {1, 0.5, 0};
    start.spin = {2, 3, 1};
    const hs_block block = scene.add_hull(solid.corners, start);
    while (scene.report().time < 60 &&
           !(scene.contact_type() != HS_CONTACT_NONE && scene.speed_of(block, 1) < 1e-9))
      scene.step(100);
    const double overlap = scene.state(block).mass * 9.81 / stiffness;
    const double rest = solid.face_distance - scene.place_of(block)[2];
    std::printf("%s: rests after %.2f s on a %s contact, overlap %.6e m, weight over stiffness %.6e m\n",
                solid.name, scene.report().time, name_of_type(scene.contact_type()), rest, overlap);
    CHECK(scene.contact_type() == HS_CONTACT_FACE_FACE);
    CHECK(scene.speed_of(block, 1) < 1e-9);
    CHECK(rest == Approx(overlap).epsilon(1e-9));
  }
}

}  // namespace
