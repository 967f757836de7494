// A hundred turns of bodies of finite elements. Case D04 of the project's list.

#include "catch.h"
#include "validation/mesh.h"

namespace {

using namespace halfspace_test;

constexpr double spin = 10;  // rad/s
constexpr int turns = 100;

}  // namespace

/// The strain energy swings about a mean that stays: that of the last fifty turns against that of the first.
/// Energy swings with the square of the time step: by 1.6e-6 for hexahedra, 4e-7 at half the step that is
/// taken by itself.
TEST_CASE("a body that turns a hundred times keeps its energy and its angular momentum", "[mesh]") {
  struct Row {
    int32_t kind;
    int count;
    double safety;
  };
  const auto [kind, count, safety] = GENERATE(Row{HS_CELL_TRIANGLE, 8, 0.5}, Row{HS_CELL_TETRAHEDRON, 2, 0.5},
                                              Row{HS_CELL_HEXAHEDRON, 2, 0.25});
  INFO(name_of_cell(kind));
  const int dimension = dimension_of(kind);
  hs_world_def def = mesh_world_def(dimension);
  def.safety = safety;
  MeshScene scene(def, area_law(1), 2000, {1e9, 0.25});
  const MeshWords words =
      brick(dimension, {1, 1, 1}, {count, count, count}, [kind = kind](int) { return kind; });
  const hs_body body = scene.add_mesh(words, {-0.5, -0.5, dimension == 3 ? -0.5 : 0});
  const Nodes start = scene.positions(body);
  Nodes velocities;
  for (const Node& node : start) velocities.emplace_back(-spin * node.y(), spin * node.x(), 0);
  scene.set_velocities(body, velocities);
  const double before = scene.body_state(body).kinetic_energy;
  const double momentum = angular_momentum(words, start, velocities);
  constexpr int looks = 50;  // in a turn
  const std::int64_t steps = std::int64_t(2 * pi / spin / looks / scene.report().time_step) + 1;
  double strained[2] = {}, energy_off = 0, momentum_off = 0;
  for (int turn = 0; turn < turns; ++turn) {
    for (int i = 0; i < looks; ++i) {
      scene.step(steps);
      const hs_body_state now = scene.body_state(body);
      strained[2 * turn / turns] += now.strain_energy / (turns / 2 * looks);
      energy_off = std::max(energy_off, std::abs((now.kinetic_energy + now.strain_energy) / before - 1));
    }
    momentum_off = std::max(
        momentum_off,
        std::abs(angular_momentum(words, scene.positions(body), scene.velocities(body)) / momentum - 1));
  }
  std::printf(
      "100 turns of %s: %.1f J, off by %.1e of it at most, angular momentum by %.1e, mean strain energy %.3f "
      "J "
      "and then %.3f J\n",
      name_of_cell(kind), before, energy_off, momentum_off, strained[0], strained[1]);
  CHECK(energy_off < 1e-6);
  CHECK(momentum_off < 1e-12);
  CHECK(strained[1] == Approx(strained[0]).epsilon(0.02));
}
