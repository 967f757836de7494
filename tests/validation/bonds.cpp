// Bonds between blocks of all kinds: how soft they make a body, when they fail, and what is lost then. Cases
// D07, D08 and D12 of the project's list.

#include "validation/bonds.h"

#include <numeric>

#include "catch.h"

namespace {

using namespace halfspace_test;

const hs_law_def soft = spring_law(1e3);

}  // namespace

/// D07. 1 / E' = 1 / E + 1 / (kn a) for a row of blocks of size a: here of each kind that strains.
TEST_CASE("bonds make a bar softer by what their springs give way", "[bonds]") {
  const double young = 1e9, size = 0.5, stress = 1e3;
  const bool is_affine = GENERATE(true, false);
  const double times = GENERATE(10., 100.);
  const double stiffness = times * young / size;
  MeshScene scene(mesh_world_def(2), soft, 2000, {young, 0});
  constexpr int count = 6;
  std::vector<hs_block> blocks;
  hs_body body = 0;
  if (is_affine) {
    for (int i = 0; i < count; ++i) {
      const Points square = box(size * i, 0, size * (i + 1), size);
      blocks.push_back(scene.add(square, {HS_BLOCK_AFFINE, {}, 0}));
      const double left[3] = {-stress, 0, 0}, right[3] = {stress, 0, 0};
      if (i == 0) scene.check(hs_world_add_surface_load(scene.world(), blocks.back(), 3, left));
      if (i + 1 == count) scene.check(hs_world_add_surface_load(scene.world(), blocks.back(), 1, right));
    }
  } else {
    body = scene.add_mesh(
        taken_apart(brick(2, {count * size, size, 0}, {count, 1, 0}, [](int) { return HS_CELL_QUAD; })));
    const auto nodes_at = [&](double x) {
      return scene.nodes_where(body, [&](const Node& node) { return std::abs(node.x() - x) < 1e-9; });
    };
    scene.push(body, nodes_at(0), {-stress * size / 2, 0, 0});
    scene.push(body, nodes_at(count * size), {stress * size / 2, 0, 0});
  }
  CHECK(bond_all(scene, strong_bond(stiffness)) == count - 1);
  const auto middle_of_cell = [&](int cell) {
    if (is_affine) return scene.position(blocks[std::size_t(cell)]).x;
    const Nodes nodes = scene.positions(body);
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += nodes[4 * std::size_t(cell) + i].x() / 4;
    return sum;
  };
  const auto length = [&] { return middle_of_cell(count - 1) - middle_of_cell(0); };
  const double before = length();
  relax(scene, 1e-7);
  const double strain = (length() - before) / before;
  const double expected = stress * (1 / young + 1 / (stiffness * size));
  std::printf("bar of %s blocks, kn %g E/a: E'/E %.6f, wanted %.6f\n", is_affine ? "affine" : "mesh", times,
              stress / strain / young, stress / expected / young);
  CHECK(strain == Approx(expected).epsilon(1e-5));
}

/// D08. A face that slides under pressure bears c + p tan(phi), then p tan(phi): at the break the pressure
/// stays.
TEST_CASE("a bond in direct shear has its peak and its residual strength", "[bonds]") {
  const double stiffness = 50e9, pressure = 1e6;
  hs_world_def def = mesh_world_def(2);
  def.time_step = 1e-7;
  MeshScene scene(def, soft, 2500, {1e13, 0});
  const hs_block lower = scene.add(box(0, -1, 1, 0), {HS_BLOCK_FIXED, {}, 0});
  const hs_body upper = scene.add_mesh(brick(2, {1, 1, 0}, {1, 1, 0}, [](int) { return HS_CELL_QUAD; }));
  hs_bond_def bond = bond_def(stiffness);
  bond.tensile_strength = 1e6;
  bond.cohesion = 0.5e6;
  bond.friction_angle = bond.residual_friction_angle = 30 * degree;
  CHECK(bond_all(scene, bond) == 1);
  scene.hold(upper, {0, 1, 2, 3}, 3, {0, -1, 0});
  scene.step(std::int64_t(std::round(pressure / stiffness / 1e-7)));
  scene.hold(upper, {0, 1, 2, 3}, 3, {0.1, 0, 0});
  double peak = 0, slip_at_peak = 0;
  for (int i = 1; i <= 4000; ++i) {
    const hs_bond before = bonds_of(scene)[0];
    scene.step();
    const hs_bond now = bonds_of(scene)[0];
    const double shear = std::abs(now.shear_force[0]);
    if (shear > peak) slip_at_peak = 0.1 * i * 1e-7;
    peak = std::max(peak, shear);
    if (now.broken_count == before.broken_count) continue;
    CHECK(now.normal_force == Approx(before.normal_force).epsilon(1e-9));
    CHECK(shear == Approx(pressure * std::tan(30 * degree)).epsilon(1e-6));
  }
  const double strength = 0.5e6 + pressure * std::tan(30 * degree),
               residual = pressure * std::tan(30 * degree);
  const double lost = (square_of(strength) - square_of(residual)) / (2 * stiffness);
  std::printf("direct shear: peak %.6g Pa, residual %.6g Pa, slip at the peak %.4g m, lost %.4g J/m2\n", peak,
              std::abs(bonds_of(scene)[0].shear_force[0]), slip_at_peak, bond_report(scene).fracture_loss);
  CHECK(peak == Approx(1.07735e6).epsilon(1e-3));
  CHECK(std::abs(bonds_of(scene)[0].shear_force[0]) == Approx(577350).epsilon(1e-5));
  CHECK(slip_at_peak == Approx(2.155e-5).epsilon(1e-3));
  CHECK(bond_report(scene).fracture_loss == Approx(lost).epsilon(1e-3));
  (void)lower;
}

/// Bending opens a face from its stretched end, though its mean stress is 0: a moment of st L^2 / 6 brings
/// that end to its strength.
TEST_CASE("a bond breaks by bending", "[bonds]") {
  MeshScene scene(mesh_world_def(2), soft, 2000, {1e9, 0});
  scene.add(box(0, -1, 1, 0), {HS_BLOCK_FIXED, {}, 0});
  const hs_block upper = scene.add(box(0, 0, 1, 1));
  hs_bond_def bond = bond_def(1e10);
  bond.tensile_strength = 1e5;
  bond.cohesion = 1e6;
  CHECK(bond_all(scene, bond) == 1);
  const double strength = 1e5 / 6;
  scene.apply(upper, {0, 0}, 0.999 * strength);
  relax(scene, 1e-6);  // holds bonds: a moment applied at once overshoots
  scene.step(10);
  CHECK(events_of(scene).empty());
  scene.apply(upper, {0, 0}, 1.001 * strength);
  relax(scene, 1e-6);
  scene.step(10);
  REQUIRE(events_of(scene).size() >= 1);
  CHECK(events_of(scene)[0].failure == HS_BOND_TENSION);
  CHECK(events_of(scene)[0].position[0] == Approx(1).margin(1e-4));  // counter-clockwise: the right end opens
}

/// A bond that fades takes its fracture energy, and no more.
TEST_CASE("a face that opens slowly takes its fracture energy", "[bonds]") {
  hs_world_def def = mesh_world_def(2);
  def.time_step = 1e-6;
  MeshScene scene(def, soft, 2500, {1e13, 0});
  scene.add(box(0, -1, 1, 0), {HS_BLOCK_FIXED, {}, 0});
  const hs_body upper = scene.add_mesh(brick(2, {1, 1, 0}, {1, 1, 0}, [](int) { return HS_CELL_QUAD; }));
  hs_bond_def bond = bond_def(1e10);
  bond.tensile_strength = 1e6;
  bond.cohesion = 1e6;
  bond.tensile_fracture_energy = 200;
  CHECK(bond_all(scene, bond) == 1);
  const double end = 1e-4 + 2 * 200 / 1e6;  // opening at the end
  scene.hold(upper, {0, 1, 2, 3}, 3, {0, 1, 0});
  scene.step(std::int64_t(0.5 * end / 1e-6));
  const double half_open = bonds_of(scene)[0].normal_force;
  CHECK(half_open == Approx(1e6 * (1 - (0.5 * end - 1e-4) / (end - 1e-4))).epsilon(0.01));
  scene.hold(upper, {0, 1, 2, 3}, 3, {0, -1, 0});
  scene.step(std::int64_t(0.25 * end / 1e-6));  // back on the line to the origin
  CHECK(bonds_of(scene)[0].normal_force == Approx(half_open / 2).epsilon(0.01));
  scene.hold(upper, {0, 1, 2, 3}, 3, {0, 1, 0});
  scene.step(std::int64_t(end / 1e-6));
  CHECK(bonds_of(scene)[0].is_joint == 0);
  std::printf("a face that opens slowly: lost %.4g J/m2 of %g\n", bond_report(scene).fracture_loss,
              200 + 50.0);
  CHECK(bond_report(scene).fracture_loss == Approx(200 + 0.5 * 1e6 * 1e-4).epsilon(0.01));
  CHECK(events_of(scene).size() == 3);
}

/// The upper block is so heavy that it goes on as it does, whatever holds it. Contact is as stiff as the
/// bond. Its face has unit size: bond.h says that a joint ends after a slip of a tenth.
TEST_CASE("a joint that has slid far hands its friction over to the contact", "[bonds]") {
  const int dimension = GENERATE(2, 3);
  const int32_t kind = GENERATE(int32_t(HS_STIFFNESS_PER_CONTACT), int32_t(HS_STIFFNESS_PER_AREA));
  CAPTURE(dimension, name_of_stiffness(kind));
  constexpr double stiffness = 1e9, friction_angle = 30 * degree;
  hs_world_def def = mesh_world_def(dimension);
  def.time_step = 1e-5;
  hs_law_def law = spring_law(stiffness, friction_angle);
  law.stiffness_kind = kind;
  MeshScene scene(def, law, 2500, {1e9, 0.25});
  const int32_t heavy = scene.add_material(1e9);
  const std::size_t up = std::size_t(dimension) - 1;
  const auto add = [&](double middle, int32_t block_kind, int32_t material) {
    if (dimension == 2)
      return scene.add(box(0, middle - 0.5, 1, middle + 0.5), {block_kind, {}, 0}, material);
    return scene.add_hull(cuboid({1, 1, 1}), {{0, 0, middle}, {0, 0, 0, 1}, block_kind, {}, {}, material});
  };
  add(0.5, HS_BLOCK_FIXED, 0);
  const hs_block upper = add(1.5, HS_BLOCK_RIGID, heavy);
  hs_bond_def bond = bond_def(stiffness);
  bond.cohesion = bond.tensile_strength = 1e4;
  bond.friction_angle = friction_angle;
  std::int64_t count = 0;
  scene.check(hs_world_bond_materials(scene.world(), 0, heavy, &bond, &count));
  REQUIRE(count == 1);
  const auto move = [&](double along, double across, double upwards) {
    double velocity[3] = {along, across, 0};
    velocity[up] = upwards;
    const double none[3] = {};
    scene.check(hs_world_set_velocity(scene.world(), upper, velocity, none));
  };
  move(0, 0, -1);
  scene.step(10);
  dimension == 2 ? move(1, 0, 0) : move(0.8, 0.6, 0);
  scene.step(100);
  double least = 1, most = 0, slip = 0;
  int after = 0;
  while (after < 100) {
    scene.step();
    const hs_block_state state = scene.state(upper);
    if (bonds_of(scene)[0].is_joint) {
      const double* place = state.pose.position;
      slip = dimension == 2 ? place[0] - 0.5 : std::hypot(place[0], place[1]);
    }
    const double shear =
        dimension == 2 ? std::abs(state.force[0]) : std::hypot(state.force[0], state.force[1]);
    least = std::min(least, shear / state.force[up]);
    most = std::max(most, shear / state.force[up]);
    if (!bonds_of(scene)[0].is_joint) ++after;
  }
  std::printf("joint that has slid far, %dD, %s: friction from %.6f to %.6f, wanted %.6f\n", dimension,
              name_of_stiffness(kind), least, most, std::tan(friction_angle));
  CHECK(least == Approx(std::tan(friction_angle)).epsilon(1e-3));
  CHECK(most == Approx(std::tan(friction_angle)).epsilon(1e-3));
  CHECK(slip == Approx(0.1).epsilon(1e-3));
}

/// D12. The books of what shatters close, the better the smaller the step, and mirror twins shatter alike.
/// Contacts slide without friction: what springs per area lose of it in collisions as violent as these is
/// theirs, with bonds or without.
TEST_CASE("a body that shatters keeps its books", "[bonds]") {
  double lost[2], residual[2];
  std::size_t count[2];
  for (const int twin : {0, 1}) {
    hs_world_def def = mesh_world_def(2);
    MeshScene scene(def, area_law(1e11, 0), 2000, {1e9, 0.25});
    MeshWords words = brick(2, {1, 1, 0}, {10, 10, 0}, [](int) { return HS_CELL_TRIANGLE; });
    if (twin == 1) {
      for (Node& node : words.nodes) node.x() = 1 - node.x();
      for (std::size_t i = 0; i < words.cell_nodes.size(); i += 3)
        std::swap(words.cell_nodes[i], words.cell_nodes[i + 1]);
    }
    scene.add_mesh(taken_apart(words), {0, 0.12, 0}, {0, -10, 0});
    const double tilt = (twin == 0 ? 10 : -10) * degree;
    scene.add_at(box(-3, -0.5, 3, 0.5), {0.5 + 0.5 * std::sin(tilt), -0.5 * std::cos(tilt)}, tilt,
                 {HS_BLOCK_FIXED, {}, 0});
    hs_bond_def bond = bond_def(1e11);
    bond.tensile_strength = 0.2e6;
    bond.cohesion = 0.4e6;
    bond.friction_angle = bond.residual_friction_angle = 30 * degree;
    CHECK(bond_all(scene, bond) == 280);
    while (scene.report().time < 0.012) scene.step(20);
    const std::vector<hs_bond_event> events = events_of(scene);
    const double of_events = std::accumulate(
        events.begin(), events.end(), 0.0, [](double sum, const auto& event) { return sum + event.energy; });
    lost[twin] = bond_report(scene).fracture_loss;
    count[twin] = events.size();
    residual[twin] = scene.energy().residual;
    std::printf("shatter: %zu of 840 points failed, lost %.4g J, residual %.3g J of 1e5\n", events.size(),
                lost[twin], residual[twin]);
    CHECK(events.size() > 600);
    CHECK(of_events == Approx(lost[twin]).epsilon(1e-9));
    CHECK(std::abs(residual[twin]) < 2e-3 * 1e5);
  }
  CHECK(count[0] == Approx(double(count[1])).epsilon(0.02));
  CHECK(lost[0] == Approx(lost[1]).epsilon(0.02));
}

/// D11. The factor of safety of a block that is bonded to a slope; what has failed keeps its cohesion under
/// pressure, else faces unzip from one end.
TEST_CASE("the factor of safety of a bonded block on a slope is that of theory, for each kind of block",
          "[bonds]") {
  const double slope = 35 * degree, friction_angle = 30 * degree, cohesion = 10e3, unit_weight = 25e3;
  const double normal = unit_weight * 10 * std::cos(slope), shear = unit_weight * 10 * std::sin(slope);
  const double expected = (normal * std::tan(friction_angle) + 5 * cohesion) / shear;
  CHECK(expected == Approx(1.1732).epsilon(1e-4));
  for (const int32_t kind : {HS_BLOCK_RIGID, HS_BLOCK_AFFINE, HS_BLOCK_MESH}) {
    hs_world_def def = mesh_world_def(2);
    def.gravity[0] = -9.81 * std::sin(slope);
    def.gravity[1] = -9.81 * std::cos(slope);
    MeshScene scene(def, area_law(1e9, friction_angle), unit_weight / 9.81, {1e9, 0.25});
    scene.add(box(-5, -1, 10, 0), {HS_BLOCK_FIXED, {}, 0});
    if (kind == HS_BLOCK_MESH) {
      scene.add_mesh(brick(2, {5, 2, 0}, {5, 2, 0}, [](int) { return HS_CELL_QUAD; }));
    } else {
      scene.add(box(0, 0, 5, 2), {kind, {}, 0});
    }
    hs_bond_def bond = bond_def(1e9);
    bond.cohesion = bond.residual_cohesion = cohesion;
    bond.friction_angle = bond.residual_friction_angle = friction_angle;
    bond_all(scene, bond);
    relax(scene, 1e-5);
    hs_strength_def search;
    hs_strength_def_init(&search, sizeof search);
    search.low = 0.8;
    search.high = 1.6;
    search.resolution = 0.002;
    hs_strength_report found;
    hs_world* fallen = nullptr;
    scene.check(hs_world_find_strength_factor(scene.world(), &search, &found, sizeof found, &fallen));
    const World owned(fallen);
    std::printf("slope, block of kind %d: factor of safety %.4f of %.4f, in %d trials\n", kind, found.factor,
                expected, found.trials);
    CHECK(found.factor == Approx(expected).epsilon(0.005));
    REQUIRE(fallen);
    CHECK(events_of(scene).empty());
  }
}
