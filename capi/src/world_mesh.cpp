#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mesh_handle.h"
#include "mesh_nodes.h"
#include "sized_struct.h"
#include "strided_view.h"
#include "tensor.h"
#include "world_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {

template <>
hs_body_def default_definition() {
  hs_body_def def{};
  def.pose.rotation[3] = 1;
  return def;
}

namespace {

/// Returns the material of each cell; refuses materials without elasticity.
template <int D>
Array<std::int32_t> read_materials(const hs_world& handle, const World<D>& world, const Mesh<D>& mesh,
                                   std::int32_t common, const std::int32_t* given) {
  Array<std::int32_t> materials(mesh.cell_count(), common, &handle.context->memory);
  if (given) std::copy_n(given, mesh.cell_count(), materials.begin());
  for (std::size_t cell = 0; cell < materials.size(); ++cell) {
    const ArgumentName name =
        given ? ArgumentName("cell_materials", std::int64_t(cell)) : ArgumentName("def.material");
    require_material(world, materials[cell], name);
    if (!world.model().materials.elasticity(materials[cell]).is_given()) {
      refuse(HS_ERROR_STATE,
             "the material of cell %zu is %d, which has no elasticity; call hs_world_set_elasticity() first",
             cell, materials[cell]);
    }
  }
  return materials;
}

/// Reads the pose of a mesh. Cells have the same limit of position as a block of their size.
template <int D>
Pose<D> read_frame(const hs_pose* given, const Mesh<D>& mesh) {
  const Pose<D> pose = read_pose<D>(given, "def.pose");
  for (std::size_t cell = 0; cell < mesh.cell_count(); ++cell) {
    with_nodes(mesh, cell, [&]<int N>(const Eigen::Matrix<double, D, N>& nodes) {
      const Vector<D> middle = nodes.rowwise().mean();
      const double radius = (nodes.colwise() - middle).colwise().norm().maxCoeff();
      const Vector<D> place = pose.position + pose.rotation.tensor() * middle;
      const double farthest = farthest_place * radius;
      if (place.cwiseAbs().maxCoeff() <= farthest) return;
      refuse(HS_ERROR_ARGUMENT,
             "def.pose puts cell %zu at %s; for a cell of radius %g coordinates must be at most %g, to limit "
             "rounding relative to its size",
             cell, PointText(place).characters, radius, farthest);
    });
  }
  return pose;
}

/// Refuses a mesh at its pose. If the cell out of bounds is not known, the text has the lowest density and
/// the highest shear modulus of all cells.
template <int D>
[[noreturn]] void refuse_placed(const World<D>& world, const MeshFaultReport& report,
                                const Array<std::int32_t>& materials) {
  const char* const text = fault_text(report.fault);
  if (report.fault == MeshFault::inside_out) {
    refuse(HS_ERROR_GEOMETRY, "cell %lld of mesh %s at def.pose", static_cast<long long>(report.cell), text);
  }
  if (report.cell >= 0) {
    const std::int32_t material = materials[std::size_t(report.cell)];
    refuse(HS_ERROR_ARGUMENT,
           "cell %lld of mesh %s: its material %d has a density of %g and a shear modulus of %g",
           static_cast<long long>(report.cell), text, material, world.model().materials.density(material),
           world.model().materials.elasticity(material).shear_modulus);
  }
  double density = HUGE_VAL, shear_modulus = 0;
  for (const std::int32_t material : materials) {
    density = std::min(density, world.model().materials.density(material));
    shear_modulus = std::max(shear_modulus, world.model().materials.elasticity(material).shear_modulus);
  }
  refuse(HS_ERROR_ARGUMENT, "mesh %s: its materials have densities from %g and shear moduli up to %g", text,
         density, shear_modulus);
}

/// Components along axes that are not held are ignored.
template <int D>
Vector<D> read_held_velocity(const double* velocity, std::int32_t axes) {
  Vector<D> held = Vector<D>::Zero();
  if (axes != 0) require_pointer(velocity, "velocity");
  for (int k = 0; k < D; ++k) {
    if (axes >> k & 1) held[k] = require_component(velocity[k], "velocity", k);
  }
  return held;
}

/// Validates all nodes, then calls use(node) with the index of each in the world's arrays.
template <int D, class Use>
void for_each_node(const Body<D>& body, const std::int32_t* nodes, std::int64_t count, Use&& use) {
  require_nodes(body, nodes, count);
  for (std::int64_t i = 0; i < count; ++i) use(std::size_t(body.first_node + nodes[i]));
}

template <int D>
std::span<const std::int32_t> read_cells(const Body<D>& body, const std::int32_t* cells, std::int64_t count) {
  require_count(count, "count");
  if (count > 0) require_pointer(cells, "cells");
  for (std::int64_t i = 0; i < count; ++i) {
    if (cells[i] < 0 || cells[i] >= body.cell_count) {
      refuse(HS_ERROR_ARGUMENT, "cells[%lld] is %d; the body has %lld cells", static_cast<long long>(i),
             cells[i], static_cast<long long>(body.cell_count));
    }
  }
  return {cells, std::size_t(count)};
}

/// True if a body would have no cells.
template <int D>
bool keeps_none(const Meshes<D>& meshes, std::int32_t body, std::span<const std::int32_t> without,
                Memory* memory) {
  Array<std::uint8_t> is_gone(std::size_t(meshes.body(body).cell_count), 0, memory);
  for (const std::int32_t cell : without) is_gone[std::size_t(cell)] = 1;
  bool keeps_some = false;
  meshes.for_each_element_of(
      body, [&](const auto& element) { keeps_some = keeps_some || !is_gone[std::size_t(element.cell)]; });
  return !keeps_some;
}

/// The body of an entry point that writes a vector per node.
template <class VectorOf>
hs_status write_nodes(const hs_world* world, hs_body body, const hs_mutable_view& out, int64_t* count,
                      const char* name, const char* function, VectorOf&& vector_of) {
  return with_world(world, function, [&]<int D>(const World<D>& w) {
    require_view<D>(out, name);
    const Body<D>& known = w.blocks().meshes().body(body_of(w.blocks().meshes(), body, "body"));
    if (count) *count = known.node_count;
    return write_all(known.node_count, out.count, [&](int i) {
      write_point(out, i, vector_of(w, known, std::size_t(known.first_node + i)));
    });
  });
}

template <int D, int N>
hs_cell_state state_of(const World<D>& world, const Element<D, N>& element) {
  using E = Element<D, N>;
  const typename E::Field field =
      element.field_of(gathered<D, N>(world.blocks().meshes().place, element.node));
  const Elasticity& elasticity = world.model().materials.elasticity(element.material);
  const Tensor<D> strain = E::strain_of(field);
  hs_cell_state state{};
  write_tensor<D>(strain, state.strain);
  write_tensor<D>(element.stress(field, elasticity), state.stress);
  state.strain_energy = element.strain_energy(strain, E::bending_of(field), elasticity);
  return state;
}

template <int D>
hs_body_state state_of(const World<D>& world, std::int32_t which) {
  const Meshes<D>& meshes = world.blocks().meshes();
  const Body<D>& body = meshes.body(which);
  hs_body_state state{};
  state.node_count = body.node_count;
  state.cell_count = body.cell_count;
  Vector<D> momentum = Vector<D>::Zero(), moment_of_mass = Vector<D>::Zero();
  for (std::size_t i = std::size_t(body.first_node); i < std::size_t(body.first_node + body.node_count);
       ++i) {
    state.mass += meshes.mass[i];
    momentum += meshes.mass[i] * meshes.velocity[i];
    moment_of_mass += meshes.mass[i] * meshes.place[i];
    state.kinetic_energy += 0.5 * meshes.mass[i] * meshes.velocity[i].squaredNorm();
  }
  write_vector(momentum, state.momentum);
  write_vector(Vector<D>(body.origin + moment_of_mass / state.mass), state.centroid);
  meshes.for_each_element_of(
      which, [&](const auto& element) { state.strain_energy += state_of(world, element).strain_energy; });
  return state;
}

}  // namespace
}  // namespace halfspace::capi

hs_status hs_body_def_init(hs_body_def* def, size_t size) { return write_definition(def, size); }

hs_status hs_world_add_mesh(hs_world* world, const hs_mesh* mesh, const hs_body_def* def,
                            const int32_t cell_materials[], hs_body* body) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    const Mesh<D>& form = require_mesh<D>(mesh);
    require_pointer(body, "body");
    const hs_body_def known = read_definition(def, "def");
    const Array<std::int32_t> materials = read_materials(*world, w, form, known.material, cell_materials);
    const Pose<D> pose = read_frame(&known.pose, form);
    const Vector<D> velocity = read_finite_vector<D>(known.velocity, "def.velocity");
    const PlacedMesh placed = w.add_mesh(form, pose, materials);
    if (placed.report.fault != MeshFault::none) refuse_placed(w, placed.report, materials);
    const Body<D>& made = w.blocks().meshes().body(placed.body);
    for (std::int64_t i = 0; i < made.node_count; ++i)
      w.set_node_velocity(std::size_t(made.first_node + i), velocity);
    w.end_node_edits(placed.body);
    *body = id_of(w.blocks().meshes(), placed.body);
    return HS_OK;
  });
}

hs_status hs_world_remove_body(hs_world* world, hs_body body) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    w.remove_mesh(body_of(w.blocks().meshes(), body, "body"));
    return HS_OK;
  });
}

hs_status hs_world_remove_cells(hs_world* world, hs_body body, const int32_t cells[], int64_t count,
                                hs_mutable_view released) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const std::int32_t which = body_of(w.blocks().meshes(), body, "body");
    const Body<D>& known = w.blocks().meshes().body(which);
    require_view<D>(released, "released");
    const std::span<const std::int32_t> wanted = read_cells(known, cells, count);
    if (keeps_none(w.blocks().meshes(), which, wanted, &world->context->memory)) {
      refuse(HS_ERROR_STATE, "cells are all cells of the body; call hs_world_remove_body() instead");
    }
    Array<Vector<D>> forces(std::size_t(known.node_count), Vector<D>::Zero(), &world->context->memory);
    const MeshFaultReport report = w.remove_cells(which, wanted, forces);
    if (report.fault != MeshFault::none) {
      refuse(HS_ERROR_GEOMETRY, "cell %lld, at the surface after removal of cells, %s",
             static_cast<long long>(report.cell), fault_text(report.fault));
    }
    if (released.count == 0) return hs_status{HS_OK};
    return write_all(std::int64_t(forces.size()), released.count,
                     [&](int i) { write_point(released, i, forces[std::size_t(i)]); });
  });
}

hs_status hs_world_get_body_state(const hs_world* world, hs_body body, hs_body_state* state, size_t size) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_pointer(state, "state");
    require_report_size(size, sizeof(hs_body_state));
    write_sized(state_of(w, body_of(w.blocks().meshes(), body, "body")), state, size);
    return HS_OK;
  });
}

hs_status hs_world_get_node_positions(const hs_world* world, hs_body body, hs_mutable_view positions,
                                      int64_t* count) {
  return write_nodes(world, body, positions, count, "positions", __func__,
                     [](const auto& w, const auto& known, std::size_t node) {
                       return (known.origin + w.blocks().meshes().place[node]).eval();
                     });
}

hs_status hs_world_get_node_velocities(const hs_world* world, hs_body body, hs_mutable_view velocities,
                                       int64_t* count) {
  return write_nodes(
      world, body, velocities, count, "velocities", __func__,
      [](const auto& w, const auto&, std::size_t node) { return w.blocks().meshes().velocity[node]; });
}

hs_status hs_world_get_node_forces(const hs_world* world, hs_body body, hs_mutable_view forces,
                                   int64_t* count) {
  return write_nodes(
      world, body, forces, count, "forces", __func__,
      [](const auto& w, const auto&, std::size_t node) { return w.state().integrator.force_on_node(node); });
}

hs_status hs_world_set_node_velocities(hs_world* world, hs_body body, hs_view velocities) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    require_view<D>(velocities, "velocities");
    const std::int32_t which = body_of(w.blocks().meshes(), body, "body");
    const Body<D>& known = w.blocks().meshes().body(which);
    if (velocities.count != known.node_count) {
      refuse(HS_ERROR_ARGUMENT, "velocities.count is %lld; the body has %lld nodes",
             static_cast<long long>(velocities.count), static_cast<long long>(known.node_count));
    }
    const auto read = [&](std::int64_t i) { return read_finite_point<D>(velocities, i, "velocities"); };
    for (std::int64_t i = 0; i < velocities.count; ++i) read(i);  // validates all before any is set
    for (std::int64_t i = 0; i < velocities.count; ++i) {
      const std::size_t node = std::size_t(known.first_node + i);
      if (w.blocks().meshes().mass[node] > 0) w.set_node_velocity(node, read(i));
    }
    w.end_node_edits(which);
    return HS_OK;
  });
}

hs_status hs_world_hold_nodes(hs_world* world, hs_body body, const int32_t nodes[], int64_t count,
                              int32_t axes, const double velocity[3]) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const std::int32_t which = body_of(w.blocks().meshes(), body, "body");
    const Body<D>& known = w.blocks().meshes().body(which);
    if (axes < 0 || axes >= 1 << D) {
      refuse(HS_ERROR_ARGUMENT, "axes is %d; it must be a sum of HS_AXIS_ values of the dimension", axes);
    }
    const Vector<D> wanted = read_held_velocity<D>(velocity, axes);
    for_each_node(known, nodes, count, [&](std::size_t node) {
      if (w.blocks().meshes().mass[node] == 0) return;  // a node without cells stays at rest
      Vector<D> kept = w.blocks().meshes().velocity[node];
      for (int k = 0; k < D; ++k) {
        if (axes >> k & 1) kept[k] = wanted[k];
      }
      w.set_node_velocity(node, kept);
      w.hold_node(node, axes == 0 ? std::uint8_t(0) : std::uint8_t(w.blocks().meshes().held[node] | axes));
    });
    w.end_node_edits(which);
    return HS_OK;
  });
}

hs_status hs_world_set_node_force(hs_world* world, hs_body body, const int32_t nodes[], int64_t count,
                                  const double force[3]) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const Body<D>& known = w.blocks().meshes().body(body_of(w.blocks().meshes(), body, "body"));
    const Vector<D> wanted = read_finite_vector<D>(force, "force");
    for_each_node(known, nodes, count, [&](std::size_t node) { w.set_node_force(node, wanted); });
    return HS_OK;
  });
}

hs_status hs_world_set_body_stress(hs_world* world, hs_body body, const double stress[9],
                                   const double gradient[27]) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const std::int32_t which = body_of(w.blocks().meshes(), body, "body");
    StressField<D> field{read_symmetric_tensor<D>(stress, "stress"), {}};
    for (int k = 0; k < D; ++k) {
      field.gradient[std::size_t(k)].setZero();
      if (gradient)
        field.gradient[std::size_t(k)] = read_symmetric_tensor<D>(gradient + 9 * k, "gradient", 9 * k);
    }
    if (!w.set_body_stress(which, field))
      refuse(HS_ERROR_ARGUMENT, "stress and gradient strain a cell by more than 1e+06");
    return HS_OK;
  });
}

hs_status hs_world_get_cells(const hs_world* world, hs_body body, hs_cell_state cells[], int64_t capacity,
                             int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(cells, "cells");
    const std::int32_t which = body_of(w.blocks().meshes(), body, "body");
    std::fill_n(cells, std::min(capacity, w.blocks().meshes().body(which).cell_count), hs_cell_state{});
    w.blocks().meshes().for_each_element_of(which, [&](const auto& element) {
      if (element.cell < capacity) cells[element.cell] = state_of(w, element);
    });
    const std::int64_t all = w.blocks().meshes().body(which).cell_count;
    if (count) *count = all;
    return fits(all, capacity);
  });
}

hs_status hs_world_get_body_of_block(const hs_world* world, hs_block block, hs_body* body, int32_t* cell) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_pointer(body, "body");
    const std::size_t slot = std::size_t(slot_of(w.blocks(), block, "block"));
    const bool is_of_mesh = w.blocks().is_of_mesh(slot);
    *body = is_of_mesh ? id_of(w.blocks().meshes(), w.blocks().meshes().surface_of_block(slot).body) : 0;
    if (cell) *cell = is_of_mesh ? w.blocks().meshes().surface_of_block(slot).cell : -1;
    return HS_OK;
  });
}
