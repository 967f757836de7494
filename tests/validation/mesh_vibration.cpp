// The first frequency of a cantilever, against Timoshenko's beam. Case D02 of the project's list.

#include "catch.h"
#include "validation/mesh.h"

namespace {

using namespace halfspace_test;

/// A mean by nodes, each as often as cells share it: that weighs with their masses where all cells are equal.
double product(const MeshWords& words, const Nodes& a, const Nodes& b) {
  double sum = 0;
  for (const int32_t node : words.cell_nodes) sum += a[std::size_t(node)].dot(b[std::size_t(node)]);
  return sum;
}

Nodes difference(const Nodes& a, const Nodes& b) {
  Nodes way;
  for (std::size_t i = 0; i < a.size(); ++i) way.push_back(a[i] - b[i]);
  return way;
}

/// Damping brakes by the velocity of half a step before: at the whole stable step that would be too late.
TEST_CASE("a column comes to rest at its whole stable step as at half of it", "[mesh]") {
  Nodes rest[3];
  double stable = 0;
  for (const int i : {0, 1, 2}) {
    hs_world_def def = mesh_world_def(2);
    def.gravity[1] = -9.81;
    if (i == 1) def.safety = 1;
    if (i == 2) def.time_step = stable;
    MeshScene scene(def, area_law(1), 2000, {1e9, 0, HS_PLANE_STRAIN});
    const hs_body body = scene.add_mesh(brick(2, {1, 4, 1}, {1, 4, 1}, [](int) { return HS_CELL_QUAD; }));
    scene.hold(body, scene.nodes_where(body, [](const Node& node) { return node.y() < 1e-9; }),
               HS_AXIS_X + HS_AXIS_Y);
    stable = scene.report().stable_time_step;
    relax(scene, 1e-8);
    rest[i] = scene.positions(body);
  }
  // The sag is rho g h^2 / 2E = 1.6e-4 m.
  for (const int i : {1, 2}) {
    double apart = 0;
    for (const Node& node : difference(rest[0], rest[i])) apart = std::max(apart, node.norm());
    CHECK(apart < 1e-9);
  }
}

}  // namespace

/// The beam is bent by a force at its tip, and let go. The product of what it is bent by then and at the
/// start changes its sign twice a period: the second mode has 1e-3 of it, which moves the sign's changes by
/// as much of a period / 2 pi. The ratios are those of full elements, worked out with another solver.
/// Hexahedra are clamped in the plane only: across it they would be faster by 0.4 %.
TEST_CASE("a cantilever swings at the frequency of its elements", "[mesh]") {
  struct Row {
    int32_t kind;
    int rows;
    double ratio;
  };
  const auto row =
      GENERATE(Row{HS_CELL_TRIANGLE, 1, 2.05}, Row{HS_CELL_TRIANGLE, 2, 1.36}, Row{HS_CELL_QUAD, 1, 0.995},
               Row{HS_CELL_QUAD, 2, 1.001}, Row{HS_CELL_HEXAHEDRON, 1, 0.995});
  const int dimension = dimension_of(row.kind);
  MeshScene scene(mesh_world_def(dimension), area_law(1), 2500,
                  {10e9, 0.25, dimension == 2 ? HS_PLANE_STRESS : HS_PLANE_STRAIN});
  const MeshWords words =
      brick(dimension, {10, 1, 1}, {10 * row.rows, row.rows, row.rows}, [&](int) { return row.kind; });
  const hs_body body = scene.add_mesh(words);
  scene.hold(body, scene.nodes_where(body, [](const Node& node) { return node.x() < 1e-9; }),
             HS_AXIS_X + HS_AXIS_Y);
  if (dimension == 3)
    scene.hold(body,
               scene.nodes_where(
                   body, [](const Node& node) { return node.head<2>().norm() < 1e-9 && node.z() < 1e-9; }),
               HS_AXIS_Z);
  const std::vector<int32_t> tip =
      scene.nodes_where(body, [](const Node& node) { return node.x() > 10 - 1e-9; });
  const Nodes straight = scene.positions(body);
  scene.push(body, tip, {0, -1e3 / double(tip.size()), 0});
  relax(scene, 1e-6);
  const Nodes bent = difference(scene.positions(body), straight);
  scene.push(body, tip, {0, 0, 0});

  constexpr int periods = 2;
  std::vector<double> changes;
  double before = product(words, bent, bent), time_before = scene.report().time;
  while (int(changes.size()) <= 2 * periods) {
    scene.step();
    const double now = product(words, bent, difference(scene.positions(body), straight)),
                 time = scene.report().time;
    if (now * before < 0) changes.push_back(time_before + (time - time_before) * before / (before - now));
    before = now;
    time_before = time;
  }
  const double frequency = periods / (changes.back() - changes.front());
  std::printf("cantilever, %s, %d over the height: swings at %.4f of Timoshenko's frequency, wanted %.3f\n",
              name_of_cell(row.kind), row.rows, frequency / 3.2057, row.ratio);
  CHECK(frequency / 3.2057 == Approx(row.ratio).epsilon(0.005));
}
