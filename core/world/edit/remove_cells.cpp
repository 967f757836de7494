#include <algorithm>

#include "block/mesh/surface.h"
#include "world/world.h"

// Excavation: removes cells from a body. The new surface is that of a mesh of the remaining cells; its parts
// that existed before keep their blocks.

namespace halfspace {
namespace {

/// The remaining cells, as a mesh of the body's nodes.
template <int D>
struct LeftCells {
  explicit LeftCells(Memory* memory) : mesh(memory), number(memory), material(memory) {}

  Mesh<D> mesh;
  Array<std::int32_t> number;    // per remaining cell: its number in the body
  Array<std::int32_t> material;  // per number in the body
};

constexpr CellKind kind_of(int dimension, int nodes) {
  if (dimension == 2) return nodes == 3 ? CellKind::triangle : CellKind::quad;
  return nodes == 4 ? CellKind::tetrahedron : nodes == 6 ? CellKind::prism : CellKind::hexahedron;
}

template <int D>
LeftCells<D> cells_left(const Meshes<D>& meshes, std::int32_t which, const Array<std::uint8_t>& is_gone,
                        Memory* memory) {
  const Body<D>& body = meshes.body(which);
  const std::int32_t first = std::int32_t(body.first_node);
  LeftCells<D> left(memory);
  left.material.resize(is_gone.size(), 0);
  meshes.for_each_element_of(which, [&]<int N>(const Element<D, N>& element) {
    if (is_gone[std::size_t(element.cell)]) return;
    left.mesh.kinds.push_back(kind_of(D, N));
    for (const std::int32_t node : element.node) left.mesh.cell_nodes.push_back(node - first);
    left.mesh.first_of_cell.push_back(std::int32_t(left.mesh.cell_nodes.size()));
    left.number.push_back(element.cell);
    left.material[std::size_t(element.cell)] = element.material;
  });
  return left;
}

/// The new part of the surface of the remaining cells.
template <int D>
Array<SurfaceSimplex<D>> new_simplices(const Meshes<D>& meshes, std::int32_t which, const LeftCells<D>& left,
                                       Memory* memory) {
  const std::int32_t first = std::int32_t(meshes.body(which).first_node);
  const auto precedes = [](const SurfaceSimplex<D>& a, const SurfaceSimplex<D>& b) {
    return std::tie(a.cell, a.node) < std::tie(b.cell, b.node);
  };
  Array<SurfaceSimplex<D>> known(memory);
  for (const SurfaceCell<D>& cell : meshes.surface_of(which)) {
    SurfaceSimplex<D> simplex{cell.cell, cell.node};
    for (std::int32_t& node : simplex.node) node -= first;
    known.push_back(simplex);
  }
  std::sort(known.begin(), known.end(), precedes);
  Array<SurfaceSimplex<D>> new_blocks(memory);
  for (SurfaceSimplex<D> simplex : surface_simplices(left.mesh, memory)) {
    simplex.cell = left.number[std::size_t(simplex.cell)];
    if (!std::binary_search(known.begin(), known.end(), simplex, precedes)) new_blocks.push_back(simplex);
  }
  return new_blocks;
}

/// Adds the nodal forces of the removed cells to `released`. The caller can fade them out, because a sudden
/// release shakes the body.
template <int D>
void release(const Model<D>& model, std::int32_t which, const Array<std::uint8_t>& is_gone,
             std::span<Vector<D>> released) {
  const Meshes<D>& meshes = model.blocks.meshes();
  const std::size_t first = std::size_t(meshes.body(which).first_node);
  meshes.for_each_element_of(which, [&]<int N>(const Element<D, N>& element) {
    if (!is_gone[std::size_t(element.cell)]) return;
    const auto forces = element.elastic_forces(element.field_of(gathered<D, N>(meshes.place, element.node)),
                                               model.materials.elasticity(element.material));
    for (int i = 0; i < N; ++i) released[std::size_t(element.node[std::size_t(i)]) - first] += forces.col(i);
  });
}

}  // namespace

template <int D>
MeshFaultReport World<D>::remove_cells(std::int32_t which, std::span<const std::int32_t> cells,
                                       std::span<Vector<D>> released) {
  Memory* memory = state_.memory();
  Blocks<D>& blocks = model_.blocks;
  Meshes<D>& meshes = blocks.meshes();
  Array<std::uint8_t> is_gone(std::size_t(meshes.body(which).cell_count), 0, memory);
  for (const std::int32_t cell : cells) is_gone[std::size_t(cell)] = 1;
  const LeftCells<D> left = cells_left(meshes, which, is_gone, memory);
  const Array<SurfaceSimplex<D>> new_blocks = new_simplices(meshes, which, left, memory);
  state_.contacts.make_room_for_blocks(blocks.slot_count() + new_blocks.size());
  Array<int> bearing(std::size_t(meshes.body(which).node_count), 0, memory);
  const std::size_t before = meshes.surface().size();
  const std::size_t first_node = std::size_t(meshes.body(which).first_node);
  const double steepest = meshes.body(which).steepest;
  const auto take_back = [&] {
    for (std::size_t i = meshes.surface().size(); i-- > before;) blocks.take_back(meshes.surface()[i].block);
    meshes.take_back_surface(before, which, steepest);
  };
  MeshFaultReport report;
  try {
    report = add_surface(which, new_blocks, left.material);
  } catch (...) {
    take_back();
    throw;
  }
  if (report.fault != MeshFault::none) {
    take_back();
    return report;
  }
  release(model_, which, is_gone, released);
  for (std::size_t i = before; i < meshes.surface().size(); ++i) state_.note_added(meshes.surface()[i].block);
  for (const SurfaceCell<D>& cell : meshes.surface()) {
    if (cell.body == which && is_gone[std::size_t(cell.cell)]) remove_block(cell.block);
  }
  for (std::size_t i = 0; i < released.size(); ++i)
    released[i] += meshes.mass[first_node + i] * model_.settings.gravity;
  meshes.remove_cells(which, is_gone, model_.materials.bulk());
  for (std::size_t i = 0; i < released.size(); ++i) {
    const double mass = meshes.mass[first_node + i];
    released[i] -= mass * model_.settings.gravity;
    if (mass == 0) released[i].setZero();
  }
  weigh_surface(which, bearing);
  blocks.bonds().rings().invalidate();
  state_.change_pairs();
  return report;
}

#define HALFSPACE_MEMBERS(D)                                                                   \
  template MeshFaultReport World<D>::remove_cells(std::int32_t, std::span<const std::int32_t>, \
                                                  std::span<Vector<D>>);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
