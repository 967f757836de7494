#pragma once

#include <cstdint>
#include <span>

#include "block/mesh/cell.h"
#include "geometry/vector.h"

namespace halfspace {

/// Faults that keep nodes and cells from being a mesh.
enum class MeshFault {
  none,
  no_cells,
  wrong_kind,   // unknown, or of another dimension
  wrong_count,  // of the cells' nodes
  no_such_node,
  node_twice,    // in one cell
  out_of_range,  // a node
  unused_node,
  inside_out,      // a cell, at some point, or flat
  face_too_often,  // in more than two cells
  beyond_bounds,   // a cell: mass or stiffness
};

/// The fault as text, e.g. "is inside out or flat".
const char* fault_text(MeshFault fault);

/// The first fault, with its cell and node; -1 where it has none.
struct MeshFaultReport {
  MeshFault fault = MeshFault::none;
  std::int64_t cell = -1;
  std::int64_t node = -1;
};

/// A mesh: nodes, and cells that share them. The nodes of a cell are numbered as in form_of().
template <int D>
struct Mesh {
  explicit Mesh(Memory* memory)
      : nodes(memory), kinds(memory), first_of_cell(1, 0, memory), cell_nodes(memory) {}

  std::size_t cell_count() const { return kinds.size(); }
  std::span<const std::int32_t> nodes_of(std::size_t cell) const {
    const std::size_t first = std::size_t(first_of_cell[cell]);
    return {cell_nodes.data() + first, std::size_t(first_of_cell[cell + 1]) - first};
  }

  Array<Vector<D>> nodes;
  Array<CellKind> kinds;
  Array<std::int32_t> first_of_cell;  // index in cell_nodes; size: number of cells + 1
  Array<std::int32_t> cell_nodes;
};

/// Fills a mesh from the kinds of cells and their nodes, one cell after the other. Returns the first fault.
template <int D>
MeshFaultReport make_mesh(std::span<const std::int32_t> kinds, std::span<const std::int32_t> cell_nodes,
                          Mesh<D>& mesh);

/// The centre of the nodes' bounding box, the origin of a body's coordinates in a world.
template <int D>
Vector<D> middle_of(const Mesh<D>& mesh) {
  Vector<D> lower = mesh.nodes.front(), upper = lower;
  for (const Vector<D>& node : mesh.nodes) {
    lower = lower.cwiseMin(node);
    upper = upper.cwiseMax(node);
  }
  return 0.5 * lower + 0.5 * upper;
}

/// Calls use.template operator()<N>(nodes) with the number of the cell's nodes and their places.
template <int D, class Use>
auto with_nodes(const Mesh<D>& mesh, std::size_t cell, Use&& use) {
  const auto call = [&]<int N>() {
    Eigen::Matrix<double, D, N> places;
    for (int i = 0; i < N; ++i) places.col(i) = mesh.nodes[std::size_t(mesh.nodes_of(cell)[std::size_t(i)])];
    return use.template operator()<N>(places);
  };
  if constexpr (D == 2) {
    return mesh.kinds[cell] == CellKind::triangle ? call.template operator()<3>()
                                                  : call.template operator()<4>();
  } else {
    switch (mesh.kinds[cell]) {
      case CellKind::tetrahedron:
        return call.template operator()<4>();
      case CellKind::prism:
        return call.template operator()<6>();
      default:
        return call.template operator()<8>();
    }
  }
}

}  // namespace halfspace
