// A thick ring under inner pressure, against Lame's solution. Case D09 of the project's list.

#include "catch.h"
#include "validation/mesh.h"

namespace {

using namespace halfspace_test;

constexpr double inner = 1, outer = 5, pressure = 1e6;
constexpr int around = 24, across = 24;

/// A quarter of it, of quads that are as long as they are wide.
MeshWords quarter_ring() {
  MeshWords words;
  for (int j = 0; j <= around; ++j) {
    for (int i = 0; i <= across; ++i) {
      const double r = inner * std::pow(outer / inner, double(i) / across), angle = pi / 2 * j / around;
      words.nodes.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
  }
  for (int j = 0; j < around; ++j) {
    for (int i = 0; i < across; ++i) {
      const int node = i + j * (across + 1);
      words.add_cell(HS_CELL_QUAD, {node, node + 1, node + across + 2, node + across + 1});
    }
  }
  return words;
}

/// On the nodes of the inner edge.
void press(const MeshScene& scene, hs_body body, const MeshWords& words) {
  Nodes forces(around + 1, Node::Zero());
  for (int j = 0; j < around; ++j) {
    const auto at = [&](int row) { return words.nodes[std::size_t(row * (across + 1))]; };
    const Node edge = at(j + 1) - at(j), half = pressure / 2 * Node(edge.y(), -edge.x(), 0);
    forces[std::size_t(j)] += half;
    forces[std::size_t(j + 1)] += half;
  }
  for (int j = 0; j <= around; ++j) {
    const Node& force = forces[std::size_t(j)];
    scene.push(body, {j * (across + 1)}, {force.x(), force.y(), 0});
  }
}

}  // namespace

/// D09. The hoop stress at the inner edge is that of a parabola through the three innermost cells: a cell
/// knows its mean.
TEST_CASE("a thick ring under inner pressure widens as Lame's does", "[mesh]") {
  const Elastic elastic{10e9, 0.25};
  MeshScene scene(mesh_world_def(2), area_law(1), 2500, elastic);
  const MeshWords words = quarter_ring();
  const hs_body body = scene.add_mesh(words);
  scene.hold(body, scene.nodes_where(body, [](const Node& node) { return node.x() < 1e-9; }), HS_AXIS_X);
  scene.hold(body, scene.nodes_where(body, [](const Node& node) { return node.y() < 1e-9; }), HS_AXIS_Y);
  press(scene, body, words);
  const Nodes before = scene.positions(body);
  const hs_balance balance = relax(scene, 1e-6);
  const Nodes after = scene.positions(body);

  double widened[2] = {};
  for (int j = 0; j <= around; ++j) {
    for (const int end : {0, 1}) {
      const std::size_t node = std::size_t(j * (across + 1) + end * across);
      widened[end] += (after[node].norm() - before[node].norm()) / (around + 1);
    }
  }
  const std::vector<hs_cell_state> cells = scene.cells(body);
  double radius[3] = {}, hoop[3] = {};
  for (int j = 0; j < around; ++j) {
    for (int i = 0; i < 3; ++i) {
      const std::size_t cell = std::size_t(i + j * across);
      Node middle = Node::Zero();
      for (std::size_t k = 0; k < 4; ++k) middle += before[std::size_t(words.cell_nodes[4 * cell + k])] / 4;
      const Node across_it = Node(-middle.y(), middle.x(), 0).normalized();
      radius[i] += middle.norm() / around;
      hoop[i] += across_it.dot(tensor(cells[cell].stress) * across_it) / around;
    }
  }
  double hoop_at_edge = 0;
  for (int i = 0; i < 3; ++i) {
    double weight = 1;
    for (int k = 0; k < 3; ++k)
      if (k != i) weight *= (inner - radius[k]) / (radius[i] - radius[k]);
    hoop_at_edge += weight * hoop[i];
  }

  const auto wanted = [&](double r) {
    return (1 + elastic.poisson) * pressure * square_of(inner) /
           (elastic.young * (square_of(outer) - square_of(inner))) *
           ((1 - 2 * elastic.poisson) * r + square_of(outer) / r);
  };
  const double wanted_hoop =
      pressure * (square_of(outer) + square_of(inner)) / (square_of(outer) - square_of(inner));
  std::printf(
      "ring: widens by %.5g m inside, wanted %.5g, %.5g m outside, wanted %.5g; hoop stress %.5g Pa, wanted "
      "%.5g; %lld steps\n",
      widened[0], wanted(inner), widened[1], wanted(outer), hoop_at_edge, wanted_hoop,
      static_cast<long long>(balance.steps));
  CHECK(wanted(inner) == Approx(1.3281e-4).epsilon(1e-4));
  CHECK(widened[0] == Approx(wanted(inner)).epsilon(0.01));
  CHECK(widened[1] == Approx(wanted(outer)).epsilon(0.01));
  CHECK(hoop_at_edge == Approx(wanted_hoop).epsilon(0.03));
}
