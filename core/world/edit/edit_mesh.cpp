#include "block/mesh/make_element.h"
#include "block/mesh/surface.h"
#include "world/world.h"

// External edits: meshes.

namespace halfspace {
namespace {

/// Maximum prestrain of a cell.
constexpr double largest_prestrain = 1e6;

/// The gradients of the linear shape functions of a simplex.
template <int D>
Eigen::Matrix<double, D, D + 1> gradients_of(const std::array<Vector<D>, D + 1>& corners) {
  Tensor<D> edges;
  for (int k = 0; k < D; ++k) edges.col(k) = corners[std::size_t(k) + 1] - corners[0];
  const Tensor<D> inverse = edges.inverse().transpose();
  Eigen::Matrix<double, D, D + 1> gradients;
  gradients << -inverse.rowwise().sum(), inverse;
  return gradients;
}

}  // namespace

/// Distributes the mass of each node over its surface blocks, so that the stable step accounts for the
/// springs of all of them. `bearing`: one entry per node, all 0.
template <int D>
void World<D>::weigh_surface(std::int32_t body, Array<int>& bearing) {
  Blocks<D>& blocks = model_.blocks;
  const Meshes<D>& meshes = blocks.meshes();
  const std::size_t first_node = std::size_t(meshes.body(body).first_node);
  for (const SurfaceCell<D>& cell : meshes.surface_of(body)) {
    for (const std::int32_t node : cell.node) ++bearing[std::size_t(node) - first_node];
  }
  for (const SurfaceCell<D>& cell : meshes.surface_of(body))
    blocks.weigh(cell, meshes.masses_of(cell, bearing));
}

/// Its blocks have the masses of weigh_surface(), for an entirely new surface.
template <int D>
MeshFaultReport World<D>::add_surface(std::int32_t body, std::span<const SurfaceSimplex<D>> simplices,
                                      std::span<const std::int32_t> cell_materials) {
  Memory* memory = state_.memory();
  Blocks<D>& blocks = model_.blocks;
  Meshes<D>& meshes = blocks.meshes();
  const Body<D>& of_body = meshes.body(body);
  const std::int32_t first_node = std::int32_t(of_body.first_node);
  Array<int> bearing(std::size_t(of_body.node_count), 0, memory);
  for (const SurfaceSimplex<D>& simplex : simplices) {
    for (const std::int32_t node : simplex.node) ++bearing[std::size_t(node)];
  }
  meshes.make_room_on_surface(simplices.size(), blocks.slot_count());
  for (const SurfaceSimplex<D>& simplex : simplices) {
    std::array<Vector<D>, D + 1> corners;
    Eigen::Matrix<double, D, D + 1> places;
    SurfaceCell<D> cell;
    cell.body = body;
    cell.cell = simplex.cell;
    cell.outer_faces = simplex.outer_faces;
    for (std::size_t i = 0; i <= D; ++i) {
      const std::size_t node = std::size_t(first_node + simplex.node[i]);
      cell.node[i] = std::int32_t(node);
      corners[i] = places.col(Eigen::Index(i)) = meshes.given[node];
    }
    if (!is_upright<D, D + 1>(places) || check_simplex(corners, memory).fault != Fault::none)
      return {MeshFault::inside_out, simplex.cell};
    const Shape<D> shape = shape_of_simplex(corners, memory);
    const std::int32_t material = cell_materials[std::size_t(simplex.cell)];
    cell.gradients = gradients_of<D>(corners);
    cell.block = blocks.add(shape, BlockKind::mesh, material, model_.materials.density(material));
    blocks.put_on_surface(cell, meshes.masses_of(cell, bearing));
    const std::size_t slot = std::size_t(cell.block);
    if (!is_within_bounds(mass_of(shape, model_.materials.density(material)), blocks.inertia[slot]))
      return {MeshFault::beyond_bounds, simplex.cell};
    if (!cell.gradients.allFinite() || !blocks.deformation(slot).is_consistent())
      return {MeshFault::inside_out, simplex.cell};
  }
  return {};
}

template <int D>
PlacedMesh World<D>::add_mesh(const Mesh<D>& mesh, const Pose<D>& pose,
                              std::span<const std::int32_t> cell_materials) {
  Blocks<D>& blocks = model_.blocks;
  Meshes<D>& meshes = blocks.meshes();
  const Array<SurfaceSimplex<D>> simplices = surface_simplices(mesh, state_.memory());
  state_.contacts.make_room_for_blocks(blocks.slot_count() + simplices.size());
  PlacedMesh placed;
  placed.body = meshes.add(mesh, pose, cell_materials, model_.materials.bulk());
  const auto take_back = [&] {
    const Array<SurfaceCell<D>>& surface = meshes.surface();
    for (auto cell = surface.rbegin(); cell != surface.rend() && cell->body == placed.body; ++cell)
      blocks.take_back(cell->block);
    meshes.take_back();
  };
  try {
    placed.report = meshes.fault_of(placed.body);
    if (placed.report.fault == MeshFault::none)
      placed.report = add_surface(placed.body, simplices, cell_materials);
  } catch (...) {
    take_back();
    throw;
  }
  if (placed.report.fault != MeshFault::none) {
    take_back();
    return placed;
  }
  for (const SurfaceCell<D>& cell : meshes.surface_of(placed.body)) state_.note_added(cell.block);
  state_.change_contacts();
  return placed;
}

template <int D>
void World<D>::remove_mesh(std::int32_t body) {
  Meshes<D>& meshes = model_.blocks.meshes();
  for (const SurfaceCell<D>& cell : meshes.surface_of(body)) remove_block(cell.block);
  meshes.remove(body);
  // Nodes are renumbered.
  model_.actions.end_on_nodes(body, model_.blocks);
  model_.viscous_nodes.remove_body(body);
  model_.viscous_nodes.renew(meshes);
  state_.integrator.forget_reaction();
  if (state_.hard_contacts.is_used()) state_.contacts.neighbors().invalidate();  // nodes are renumbered
  state_.edit();
}

/// Changes nothing if the prestrain of any cell would exceed largest_prestrain.
template <int D>
bool World<D>::set_body_stress(std::int32_t body, const StressField<D>& field) {
  Meshes<D>& meshes = model_.blocks.meshes();
  const Vector<D> origin = meshes.body(body).origin;
  const auto stressed = [&]<int N>(Element<D, N> element) {
    const Eigen::Matrix<double, D, N> places = gathered<D, N>(meshes.place, element.node);
    const Vector<D> middle = origin + places.rowwise().mean();
    element.set_stress(element.field_of(places), field.at(middle),
                       model_.materials.elasticity(element.material));
    return element.prestrain;
  };
  bool is_bounded = true;
  meshes.for_each_element_of(body, [&](const auto& element) {
    is_bounded = is_bounded && stressed(element).norm() <= largest_prestrain;
  });
  if (!is_bounded) return false;
  meshes.for_each_element_of(body, [&](auto& element) { element.prestrain = stressed(element); });
  state_.edit();
  return true;
}

// A node without cells has no mass, and keeps its position.

template <int D>
void World<D>::hold_node(std::size_t node, std::uint8_t held) {
  Meshes<D>& meshes = model_.blocks.meshes();
  if (meshes.mass[node] > 0) meshes.held[node] = held;
  state_.edit();
}

template <int D>
void World<D>::set_node_velocity(std::size_t node, const Vector<D>& velocity) {
  Meshes<D>& meshes = model_.blocks.meshes();
  if (meshes.mass[node] > 0) meshes.velocity[node] = velocity;
  state_.edit();
}

template <int D>
void World<D>::set_node_force(std::size_t node, const Vector<D>& force) {
  Meshes<D>& meshes = model_.blocks.meshes();
  if (meshes.mass[node] > 0) meshes.applied_force[node] = force;
  state_.edit();
}

template <int D>
void World<D>::set_node_viscosity(std::int32_t body, std::span<const std::int32_t> nodes,
                                  const Tensor<D>& viscosity) {
  model_.viscous_nodes.set(body, nodes, viscosity, model_.blocks.meshes());
  state_.edit();
}

template <int D>
void World<D>::end_node_edits(std::int32_t body) {
  for (const SurfaceCell<D>& cell : model_.blocks.meshes().surface_of(body))
    model_.blocks.follow_node_velocities(cell);
}

#define HALFSPACE_MEMBERS(D)                                                                                 \
  template void World<D>::weigh_surface(std::int32_t, Array<int>&);                                          \
  template MeshFaultReport World<D>::add_surface(std::int32_t, std::span<const SurfaceSimplex<D>>,           \
                                                 std::span<const std::int32_t>);                             \
  template PlacedMesh World<D>::add_mesh(const Mesh<D>&, const Pose<D>&, std::span<const std::int32_t>);     \
  template void World<D>::remove_mesh(std::int32_t);                                                         \
  template bool World<D>::set_body_stress(std::int32_t, const StressField<D>&);                              \
  template void World<D>::hold_node(std::size_t, std::uint8_t);                                              \
  template void World<D>::set_node_velocity(std::size_t, const Vector<D>&);                                  \
  template void World<D>::set_node_force(std::size_t, const Vector<D>&);                                     \
  template void World<D>::set_node_viscosity(std::int32_t, std::span<const std::int32_t>, const Tensor<D>&); \
  template void World<D>::end_node_edits(std::int32_t);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
