// Regular triangles that are bonded on all sides: how soft they are together. Case D07 of the project's list.

#include "catch.h"
#include "validation/bonds.h"

namespace {

using namespace halfspace_test;

constexpr double young = 1e9, edge = 0.5, height = edge * 0.86602540378443864676;
constexpr int columns = 3, rows = 3;

/// Triangles in a parallelogram, row by row, two in each rhomb: one that stands on its edge, then one on its
/// tip. None shares nodes.
MeshWords triangles() {
  MeshWords words;
  const auto at = [](int i, int j) { return Node(edge * (i + 0.5 * j), height * j, 0); };
  const auto add = [&](const Node& a, const Node& b, const Node& c) {
    const int first = int(words.nodes.size());
    words.nodes.insert(words.nodes.end(), {a, b, c});
    words.add_cell(HS_CELL_TRIANGLE, {first, first + 1, first + 2});
  };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      add(at(i, j), at(i + 1, j), at(i, j + 1));
      add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return words;
}

/// The outer edges of the parallelogram by what this stress presses on them.
void load(const MeshScene& scene, hs_body body, const MeshWords& words, const Tensor& stress) {
  Nodes forces(words.nodes.size(), Node::Zero());
  const auto load_edge = [&](int from, int to) {
    const Node way = words.nodes[std::size_t(to)] - words.nodes[std::size_t(from)];
    const Node half = stress * Node(way.y(), -way.x(), 0) / 2;
    forces[std::size_t(from)] += half;
    forces[std::size_t(to)] += half;
  };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int standing = 6 * (i + columns * j), on_tip = standing + 3;
      if (j == 0) load_edge(standing, standing + 1);
      if (i == 0) load_edge(standing + 2, standing);
      if (i + 1 == columns) load_edge(on_tip, on_tip + 1);
      if (j + 1 == rows) load_edge(on_tip + 1, on_tip + 2);
    }
  }
  for (std::size_t i = 0; i < forces.size(); ++i)
    scene.push(body, {int32_t(i)}, {forces[i].x(), forces[i].y(), 0});
}

}  // namespace

/// D07. A face's springs give way by t / k, and all faces of one direction alike; three directions together
/// do so by 1 / E' = 1 / E + (9 / (8 kn) + 3 / (8 ks)) / s, where s is a triangle's height, along any axis.
/// The strain is 1e-4, as smaller ones are rounded. What grows with its square, as Green's does, is told from
/// the rest by twice the load; the cube is 1e-8 of it.
TEST_CASE("regular triangles that are bonded are as soft as their springs make them", "[bonds]") {
  const double stress = 1e5;
  const int axis = GENERATE(0, 1);
  const auto stiffness = GENERATE(std::array{10., 10.}, std::array{100., 100.}, std::array{20., 5.});
  const double normal = stiffness[0] * young / edge, shear = stiffness[1] * young / edge;
  MeshScene scene(mesh_world_def(2), area_law(1), 2000, {young, 0});
  const MeshWords words = triangles();
  const hs_body body = scene.add_mesh(words);
  hs_bond_def bond = strong_bond(normal);
  bond.shear_stiffness = shear;
  // Each standing triangle with the other of its rhomb, with that at its left, and with that below it.
  CHECK(bond_all(scene, bond) == 3 * columns * rows - columns - rows);
  // Between the middles of two standing triangles, one in line with the other: so far as the whole turns,
  // that is of second order.
  const auto extent = [&] {
    const Nodes nodes = scene.positions(body);
    const auto middle = [&](int i, int j) {
      const std::size_t first = std::size_t(6 * (i + columns * j));
      return Node((nodes[first] + nodes[first + 1] + nodes[first + 2]) / 3);
    };
    return axis == 0 ? middle(2, 0).x() - middle(0, 0).x() : middle(0, 2).y() - middle(1, 0).y();
  };
  const double before = extent();
  const auto extent_under = [&](double pull) {
    Tensor uniaxial = Tensor::Zero();
    uniaxial(axis, axis) = pull;
    load(scene, body, words, uniaxial);
    relax(scene, 1e-8);
    return extent();
  };
  const double once = extent_under(stress) - before, twice = extent_under(2 * stress) - before;
  const double strain = (2 * once - twice / 2) / before;
  const double softened = stress / strain / young;
  const double wanted = 1 / (1 + young * (9 / (8 * normal) + 3 / (8 * shear)) / height);
  std::printf("regular triangles along axis %d, kn %g, ks %g E/a: E'/E %.7f, wanted %.7f\n", axis,
              stiffness[0], stiffness[1], softened, wanted);
  CHECK(softened == Approx(wanted).epsilon(1e-6));
}
