// The elements of meshes against theory: the patch test, bending, spin. Cases D01, D02 and D04 of the
// project's list.

#include <functional>
#include <random>

#include "catch.h"
#include "validation/mesh.h"

namespace {

using namespace halfspace_test;

constexpr double density = 2500;
const hs_law_def soft = spring_law(1e-3);  // nothing touches

/// The gradient of a displacement that all elements must represent exactly.
Tensor patch_gradient(int dimension) {
  Tensor gradient;
  gradient << 1e-4, 2e-4, 0, 0.5e-4, -1e-4, 0, 0, 0, 0;
  if (dimension == 3) {
    gradient(1, 2) = 1e-4;
    gradient(2, 2) = 3e-5;
  }
  return gradient;
}

/// Nodes inside are moved at random, up to so far.
void distort(MeshWords& words, const Triple& size, double most) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> way(-most, most);
  for (Node& node : words.nodes) {
    bool is_inside = true;
    for (int k = 0; k < words.dimension; ++k)
      is_inside = is_inside && node[k] > 1e-9 && node[k] < size[std::size_t(k)] - 1e-9;
    for (int k = 0; k < words.dimension && is_inside; ++k) node[k] += way(random);
  }
}

/// Hooke's law of an isotropic body, in 2D in plane strain.
Tensor hooke(const Elastic& elastic, const Tensor& strain) {
  return elastic.lame() * strain.trace() * Tensor::Identity() + 2 * elastic.shear() * strain;
}

/// Cauchy's stress where the second Piola stress is linear in Green's strain.
Tensor cauchy(const Elastic& elastic, const Tensor& displacement_gradient) {
  const Tensor f = Tensor::Identity() + displacement_gradient;
  return f * hooke(elastic, 0.5 * (f.transpose() * f - Tensor::Identity())) * f.transpose() / f.determinant();
}

/// The largest difference of any cell's stress from what is expected, as a share of the largest component.
double stress_error(const std::vector<hs_cell_state>& cells, const Tensor& expected, int dimension) {
  double worst = 0;
  for (const hs_cell_state& cell : cells) {
    const Tensor difference = tensor(cell.stress) - expected;
    worst = std::max(worst, difference.topLeftCorner(dimension, dimension).cwiseAbs().maxCoeff());
  }
  return worst / expected.cwiseAbs().maxCoeff();
}

/// A brick of 3 x 3 x 3 cells, or what they are cut into.
struct Patch {
  const char* name;
  int dimension;
  std::function<int32_t(int)> cut;
};

/// Each kind of cell, and kinds side by side that have faces in common.
std::vector<Patch> all_patches() {
  std::vector<Patch> patches;
  for (const int32_t kind : all_cell_kinds)
    patches.push_back({name_of_cell(kind), dimension_of(kind), [kind](int) { return kind; }});
  patches.push_back(
      {"triangles with quads", 2, [](int i) { return i % 2 ? HS_CELL_TRIANGLE : HS_CELL_QUAD; }});
  patches.push_back(
      {"prisms with hexahedra", 3, [](int i) { return i % 9 % 2 ? HS_CELL_PRISM : HS_CELL_HEXAHEDRON; }});
  patches.push_back(
      {"prisms with tetrahedra", 3, [](int i) { return i / 9 == 1 ? HS_CELL_PRISM : HS_CELL_TETRAHEDRON; }});
  return patches;
}

}  // namespace

/// D01. The surface is moved as the field says and held; the nodes inside find their places. Stresses are
/// those of the field's gradient to rounding; from those of linear theory they differ by the size of the
/// gradient, 8e5 against 8e5 Pa and so on, by 7e-4.
TEST_CASE("a distorted patch of each kind of cell, and of several, is stressed uniformly", "[mesh]") {
  const Elastic elastic{10e9, 0.25};
  const Triple size{1, 1, 1};
  for (const auto& [name, dimension, cut] : all_patches()) {
    INFO(name);
    const Tensor gradient = patch_gradient(dimension);
    MeshWords words = brick(dimension, size, {3, 3, 3}, cut);
    distort(words, size, 0.08);
    MeshScene scene(mesh_world_def(dimension, 4000), soft, density, elastic);
    const hs_body body = scene.add_mesh(words);
    const Nodes given = scene.positions(body);
    const auto is_at_surface = [&](const Node& node) {
      for (int k = 0; k < dimension; ++k) {
        if (node[k] < 1e-9 || node[k] > 1 - 1e-9) return true;
      }
      return false;
    };
    // The surface is where the field wants it in so many steps.
    constexpr int steps = 100;
    const double time_step = scene.report().time_step;
    Nodes velocities;
    for (const Node& node : given) velocities.push_back(gradient * node / (steps * time_step));
    scene.hold(body, scene.nodes_where(body, is_at_surface), dimension == 2 ? 3 : 7);
    scene.set_velocities(body, velocities);
    scene.step(steps);
    for (Node& velocity : velocities) velocity.setZero();
    scene.set_velocities(body, velocities);
    scene.step(3000);
    const Tensor expected = hooke(elastic, 0.5 * (gradient + gradient.transpose()));
    const double error = stress_error(scene.cells(body), cauchy(elastic, gradient), dimension);
    CHECK(stress_error(scene.cells(body), expected, dimension) < 1e-3);
    const double energy = 0.5 * expected.cwiseProduct(0.5 * (gradient + gradient.transpose())).sum();
    std::printf("patch of %-22s stress off by %.1e, energy by %.1e of %.4g J\n", name, error,
                scene.body_state(body).strain_energy / energy - 1, energy);
    CHECK(error < 1e-8);
    CHECK(scene.body_state(body).strain_energy == Approx(energy).epsilon(5e-4));
  }
}

/// D02, static: Timoshenko's beam, .0403 m for a shear of 1e5 N/m, here with a hundredth of the load:
/// displacements stay small. The ratios are those of full elements that were worked out with another solver.
TEST_CASE("a cantilever bends as its elements do, and quads without locking", "[mesh]") {
  struct Row {
    int32_t kind;
    int rows;
    double ratio;
  };
  const auto row =
      GENERATE(Row{HS_CELL_TRIANGLE, 1, 0.232}, Row{HS_CELL_TRIANGLE, 2, 0.541}, Row{HS_CELL_QUAD, 1, 0.996},
               Row{HS_CELL_QUAD, 2, 0.996}, Row{HS_CELL_QUAD, 4, 0.998});
  const Triple size{10, 1, 0};
  MeshScene scene(mesh_world_def(2, 2 * pi * 3.2), soft, density, {10e9, 0.25, HS_PLANE_STRESS});
  const hs_body body =
      scene.add_mesh(brick(2, size, {10 * row.rows, row.rows, 0}, [&](int) { return row.kind; }));
  scene.hold(body, scene.nodes_where(body, [](const Node& node) { return node.x() < 1e-9; }), 3);
  const std::vector<int32_t> tip =
      scene.nodes_where(body, [](const Node& node) { return node.x() > 10 - 1e-9; });
  const Nodes before = scene.positions(body);
  for (std::size_t i = 0; i < tip.size(); ++i) {
    const bool is_corner = i == 0 || i + 1 == tip.size();
    scene.push(body, {tip[i]}, {0, -1e3 / row.rows * (is_corner ? 0.5 : 1), 0});
  }
  scene.step(std::int64_t(2.5 / scene.report().time_step));
  double sunk = 0;
  const Nodes after = scene.positions(body);
  for (const int32_t node : tip)
    sunk += (before[std::size_t(node)] - after[std::size_t(node)]).y() / double(tip.size());
  std::printf("cantilever, %s, %d over the height: %.4f of Timoshenko's, wanted %.3f\n",
              name_of_cell(row.kind), row.rows, sunk / 0.0403e-2, row.ratio);
  CHECK(sunk / 0.0403e-2 == Approx(row.ratio).epsilon(0.005));
}

/// The same beam of hexahedra and of prisms, bent about both of their axes: as exact as quads where they have
/// incompatible modes.
TEST_CASE("a cantilever of hexahedra does not lock in any direction", "[mesh]") {
  const Triple size{10, 1, 1};
  const int axis = GENERATE(1, 2);
  MeshScene scene(mesh_world_def(3, 2 * pi * 3.2), soft, density, {10e9, 0});
  const hs_body body = scene.add_mesh(brick(3, size, {10, 1, 1}, [](int) { return HS_CELL_HEXAHEDRON; }));
  scene.hold(body, scene.nodes_where(body, [](const Node& node) { return node.x() < 1e-9; }), 7);
  const std::vector<int32_t> tip =
      scene.nodes_where(body, [](const Node& node) { return node.x() > 10 - 1e-9; });
  Triple force{};
  force[std::size_t(axis)] = -1e3 / double(tip.size());
  const Nodes before = scene.positions(body);
  scene.push(body, tip, force);
  scene.step(std::int64_t(2.5 / scene.report().time_step));
  double sunk = 0;
  for (const int32_t node : tip)
    sunk += (before[std::size_t(node)] - scene.positions(body)[std::size_t(node)])[axis] / double(tip.size());
  // F L^3 / 3 E I + F L / (5/6 G A), nu = 0.
  const double timoshenko = 1e3 * 1000 / (3 * 10e9 / 12) + 1e3 * 10 / (5. / 6 * 5e9);
  std::printf("cantilever of hexahedra along axis %d: %.4f of Timoshenko's\n", axis, sunk / timoshenko);
  CHECK(sunk / timoshenko == Approx(0.996).margin(0.005));
}

/// D04. Turning strains nothing, and the ledger closes however long it turns.
TEST_CASE("a spinning body of each kind of cell keeps its energy and its angular momentum", "[mesh]") {
  for (const int32_t kind : all_cell_kinds) {
    INFO(name_of_cell(kind));
    const int dimension = dimension_of(kind);
    MeshScene scene(mesh_world_def(dimension), soft, 2000, {1e9, 0.25});
    const MeshWords words = brick(dimension, {1, 1, 1}, {2, 2, 2}, [&](int) { return kind; });
    const hs_body body = scene.add_mesh(words, {-0.5, -0.5, dimension == 3 ? -0.5 : 0});
    const Nodes start = scene.positions(body);
    Nodes velocities;
    for (const Node& node : start) velocities.emplace_back(-10 * node.y(), 10 * node.x(), 0);
    scene.set_velocities(body, velocities);
    const double before = scene.body_state(body).kinetic_energy;
    const std::int64_t turn = std::int64_t(2 * pi / 10 / scene.report().time_step);
    scene.step(5 * turn);
    const hs_body_state after = scene.body_state(body);
    std::printf("spin of %-10s %.1f J, made %.1e of it in 5 turns, strain energy %.1e\n", name_of_cell(kind),
                before, (after.kinetic_energy + after.strain_energy) / before - 1,
                after.strain_energy / before);
    CHECK(after.kinetic_energy + after.strain_energy == Approx(before).epsilon(1e-6));
    CHECK(after.strain_energy < 1e-3 * before);
    CHECK(angular_momentum(words, scene.positions(body), scene.velocities(body)) ==
          Approx(angular_momentum(words, start, velocities)).epsilon(1e-11));
  }
}

TEST_CASE("a cell that is turned inside out ends the run, and is named", "[mesh]") {
  MeshScene scene(mesh_world_def(2), soft, density, {1e9, 0.25});
  const hs_body body = scene.add_mesh(brick(2, {1, 1, 0}, {1, 1, 0}, [](int) { return HS_CELL_TRIANGLE; }));
  const double time_step = scene.report().time_step;
  scene.hold(body, {0, 2, 3}, 3);
  scene.hold(body, {1}, 3, {-0.6 / time_step, 0.6 / time_step, 0});  // beyond the diagonal, at once
  CHECK(hs_world_step(scene.world(), 1) == HS_ERROR_INVERTED);
  CHECK(std::string(hs_context_last_error(scene.context())).find("cell 0 of body") != std::string::npos);
  CHECK(scene.positions(body)[1] == Node(1, 0, 0));
  scene.hold(body, {1}, 3);
  scene.step();
}
