// Meshes in plain words, their surfaces, and what keeps words from being a mesh.

#include "block/mesh/make_element.h"
#include "block/mesh/mesh.h"
#include "block/mesh/surface.h"
#include "catch.h"

namespace {

using namespace halfspace;

Memory* const memory = std::pmr::new_delete_resource();

/// The corners of the unit cube, as a hexahedron numbers them.
Mesh<3> cube_nodes() {
  Mesh<3> mesh(memory);
  for (const double z : {0., 1.}) {
    for (const auto& [x, y] : {std::pair(0., 0.), {1., 0.}, {1., 1.}, {0., 1.}})
      mesh.nodes.emplace_back(x, y, z);
  }
  return mesh;
}

MeshFaultReport fault_of(Mesh<2> mesh, std::vector<std::int32_t> kinds, std::vector<std::int32_t> nodes) {
  return make_mesh<2>(kinds, nodes, mesh);
}

Mesh<2> square_nodes() {
  Mesh<2> mesh(memory);
  for (const auto& [x, y] : {std::pair(0., 0.), {1., 0.}, {1., 1.}, {0., 1.}}) mesh.nodes.emplace_back(x, y);
  return mesh;
}

}  // namespace

TEST_CASE("every kind of cell fills its simplices, and its nodes share its volume", "[mesh]") {
  const std::vector<std::int32_t> cells[] = {{0, 1, 3, 4}, {0, 1, 3, 4, 5, 7}, {0, 1, 2, 3, 4, 5, 6, 7}};
  const double volumes[] = {1. / 6, 0.5, 1};
  for (const int i : {0, 1, 2}) {
    Mesh<3> mesh = cube_nodes();
    const std::vector<std::int32_t> kinds{std::int32_t(CellKind::tetrahedron) + i};
    Mesh<3> used(memory);
    std::vector<std::int32_t> names;
    for (const std::int32_t node : cells[i]) {
      used.nodes.push_back(mesh.nodes[std::size_t(node)]);
      names.push_back(std::int32_t(names.size()));
    }
    REQUIRE(make_mesh<3>(kinds, names, used).fault == MeshFault::none);
    with_nodes(used, 0, [&]<int N>(const Eigen::Matrix<double, 3, N>& nodes) {
      const Elasticity elasticity{1, 1, 0};
      const Element<3, N> element = make_element<3, N>(nodes, elasticity);
      CHECK(element.volume == Approx(volumes[i]));
      CHECK(volumes_of_nodes<3, N>(nodes).sum() == Approx(volumes[i]));
      CHECK((nodes * element.gradients.transpose() - Tensor<3>::Identity()).norm() < 1e-14);
    });
    double filled = 0;
    const CellForm& form = form_of(CellKind(kinds[0]));
    for (int s = 0; s < form.simplex_count; ++s) {
      Tensor<3> edges;
      const int* corners = form.simplices[s];
      for (int k = 0; k < 3; ++k)
        edges.col(k) = used.nodes[std::size_t(corners[k + 1])] - used.nodes[std::size_t(corners[0])];
      CHECK(edges.determinant() > 0);
      filled += edges.determinant() / 6;
    }
    CHECK(filled == Approx(volumes[i]));
  }
}

TEST_CASE("the surface is what only one cell has", "[mesh]") {
  Mesh<2> mesh = square_nodes();
  REQUIRE(make_mesh<2>(std::vector<std::int32_t>{0, 0}, std::vector<std::int32_t>{0, 1, 2, 0, 2, 3}, mesh)
              .fault == MeshFault::none);
  CHECK(surface_of(mesh, memory).size() == 4);
  CHECK(surface_simplices(mesh, memory).size() == 2);
  Mesh<3> cube = cube_nodes();
  REQUIRE(make_mesh<3>(std::vector<std::int32_t>{4}, std::vector<std::int32_t>{0, 1, 2, 3, 4, 5, 6, 7}, cube)
              .fault == MeshFault::none);
  CHECK(surface_of(cube, memory).size() == 6);
  CHECK(surface_simplices(cube, memory).size() == 4);  // the fifth is inside
}

TEST_CASE("words that are no mesh are told with the cell or the node at fault", "[mesh]") {
  const auto is = [](const MeshFaultReport& report, MeshFault fault, std::int64_t cell, std::int64_t node) {
    return report.fault == fault && report.cell == cell && report.node == node;
  };
  CHECK(is(fault_of(square_nodes(), {}, {}), MeshFault::no_cells, -1, -1));
  CHECK(is(fault_of(square_nodes(), {2}, {0, 1, 2, 3}), MeshFault::wrong_kind, 0, -1));
  CHECK(is(fault_of(square_nodes(), {1}, {0, 1, 2}), MeshFault::wrong_count, 0, -1));
  CHECK(is(fault_of(square_nodes(), {1}, {0, 1, 2, 4}), MeshFault::no_such_node, 0, 4));
  CHECK(is(fault_of(square_nodes(), {1}, {0, 1, 1, 3}), MeshFault::node_twice, 0, 1));
  CHECK(is(fault_of(square_nodes(), {0}, {0, 1, 2}), MeshFault::unused_node, -1, 3));
  CHECK(is(fault_of(square_nodes(), {1}, {0, 3, 2, 1}), MeshFault::inside_out, 0, -1));
  CHECK(is(fault_of(square_nodes(), {0, 0}, {0, 1, 2, 0, 3, 2}), MeshFault::inside_out, 1, -1));
  Mesh<2> far = square_nodes();
  far.nodes[2].x() = 1e76;
  CHECK(is(fault_of(far, {1}, {0, 1, 2, 3}), MeshFault::out_of_range, -1, 2));
  Mesh<2> fan = square_nodes();
  fan.nodes.emplace_back(0.5, 2);
  CHECK(is(fault_of(fan, {0, 0, 0}, {0, 1, 2, 0, 1, 3, 0, 1, 4}), MeshFault::face_too_often, 2, -1));
}
