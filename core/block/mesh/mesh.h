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
  wrong_kind,   // no kind at all, or one of another dimension
  wrong_count,  // of the cells' nodes
  no_such_node,
  node_twice,    // in one cell
  out_of_range,  // a node
  unused_node,
  inside_out,      // a cell, somewhere, or flat
  face_too_often,  // in more than two cells
  beyond_bounds,   // a cell, in its mass or its stiffness
};

/// The fault in words, e.g. "is inside out or flat".
const char* fault_text(MeshFault fault);

/// The first fault, and the cell and node it sits at, -1 where it is none of them.
struct MeshFaultReport {
  MeshFault fault = MeshFault::none;
  std::int64_t cell = -1;
  std::int64_t node = -1;
};

/// A mesh in plain words: nodes, and cells that share them. Nodes of a cell are numbered as form_of() says.
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
  Array<std::int32_t> first_of_cell;  // in cell_nodes; one more than there are cells
  Array<std::int32_t> cell_nodes;
};

/// Says what keeps cells of these kinds, with their nodes one after the other, from being a mesh; and fills
/// it.
template <int D>
MeshFaultReport make_mesh(std::span<const std::int32_t> kinds, std::span<const std::int32_t> cell_nodes,
                          Mesh<D>& mesh);

/// The middle of the box around the nodes: in a world places are seen from there.
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
