#include "block/mesh/mesh.h"

#include <algorithm>
#include <array>

#include "block/mesh/make_element.h"
#include "block/mesh/surface.h"
#include "geometry/numbers.h"

namespace halfspace {
namespace {

template <int D>
MeshFaultReport check_nodes_of(const Mesh<D>& mesh, std::size_t cell) {
  const auto nodes = mesh.nodes_of(cell);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i] < 0 || std::size_t(nodes[i]) >= mesh.nodes.size())
      return {MeshFault::no_such_node, std::int64_t(cell), nodes[i]};
    if (std::find(nodes.begin(), nodes.begin() + std::ptrdiff_t(i), nodes[i]) !=
        nodes.begin() + std::ptrdiff_t(i))
      return {MeshFault::node_twice, std::int64_t(cell), nodes[i]};
  }
  return {};
}

template <int D>
MeshFaultReport take_cells(std::span<const std::int32_t> kinds, std::span<const std::int32_t> cell_nodes,
                           Mesh<D>& mesh) {
  if (kinds.empty()) return {MeshFault::no_cells};
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < kinds.size(); ++cell) {
    if (!is_cell_kind(kinds[cell]) || form_of(CellKind(kinds[cell])).dimension != D)
      return {MeshFault::wrong_kind, std::int64_t(cell)};
    count += std::size_t(form_of(CellKind(kinds[cell])).nodes);
    if (count > cell_nodes.size()) return {MeshFault::wrong_count, std::int64_t(cell)};
    mesh.kinds.push_back(CellKind(kinds[cell]));
    mesh.first_of_cell.push_back(std::int32_t(count));
  }
  if (count != cell_nodes.size()) return {MeshFault::wrong_count};
  mesh.cell_nodes.assign(cell_nodes.begin(), cell_nodes.end());
  return {};
}

template <int D>
MeshFaultReport check_places(const Mesh<D>& mesh) {
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    if (!(mesh.nodes[i].array().abs() <= largest_number).all())
      return {MeshFault::out_of_range, -1, std::int64_t(i)};
  }
  for (std::size_t cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto upright = [&]<int N>(const Eigen::Matrix<double, D, N>& nodes) {
      return is_upright<D, N>(nodes);
    };
    if (!with_nodes(mesh, cell, upright)) return {MeshFault::inside_out, std::int64_t(cell)};
  }
  return {};
}

template <int D>
MeshFaultReport check_surface(const Mesh<D>& mesh) {
  Memory* memory = mesh.nodes.get_allocator().resource();
  const std::int64_t too_many = cell_too_many(mesh, memory);
  if (too_many >= 0) return {MeshFault::face_too_often, too_many};
  for (const SurfaceSimplex<D>& simplex : surface_simplices(mesh, memory)) {
    std::array<Vector<D>, D + 1> corners;
    for (std::size_t i = 0; i <= D; ++i) corners[i] = mesh.nodes[std::size_t(simplex.node[i])];
    if (check_simplex(corners, memory).fault != Fault::none) return {MeshFault::inside_out, simplex.cell};
  }
  return {};
}

template <int D>
MeshFaultReport check_all_used(const Mesh<D>& mesh) {
  Array<std::uint8_t> used(mesh.nodes.size(), 0, mesh.nodes.get_allocator());
  for (const std::int32_t node : mesh.cell_nodes) used[std::size_t(node)] = 1;
  const auto unused = std::find(used.begin(), used.end(), 0);
  if (unused == used.end()) return {};
  return {MeshFault::unused_node, -1, unused - used.begin()};
}

}  // namespace

const char* fault_text(MeshFault fault) {
  switch (fault) {
    case MeshFault::none:
      return "is a mesh";
    case MeshFault::no_cells:
      return "has no cells";
    case MeshFault::wrong_kind:
      return "is of no kind that the dimension has";
    case MeshFault::wrong_count:
      return "does not have the nodes that its kinds of cells need";
    case MeshFault::no_such_node:
      return "names a node that does not exist";
    case MeshFault::node_twice:
      return "names a node twice";
    case MeshFault::out_of_range:
      return "is not finite or beyond 1e75";
    case MeshFault::unused_node:
      return "belongs to no cell";
    case MeshFault::inside_out:
      return "is inside out or flat";
    case MeshFault::face_too_often:
      return "has a face that two other cells have already";
    case MeshFault::beyond_bounds:
      return "has a mass or a stiffness beyond what can be computed with";
  }
  return "is faulty";
}

template <int D>
MeshFaultReport make_mesh(std::span<const std::int32_t> kinds, std::span<const std::int32_t> cell_nodes,
                          Mesh<D>& mesh) {
  MeshFaultReport report = take_cells(kinds, cell_nodes, mesh);
  for (std::size_t cell = 0; report.fault == MeshFault::none && cell < mesh.cell_count(); ++cell)
    report = check_nodes_of(mesh, cell);
  if (report.fault == MeshFault::none) report = check_places(mesh);
  if (report.fault == MeshFault::none) report = check_surface(mesh);
  if (report.fault == MeshFault::none) report = check_all_used(mesh);
  return report;
}

template MeshFaultReport make_mesh(std::span<const std::int32_t>, std::span<const std::int32_t>, Mesh<2>&);
template MeshFaultReport make_mesh(std::span<const std::int32_t>, std::span<const std::int32_t>, Mesh<3>&);

}  // namespace halfspace
