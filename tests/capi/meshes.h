#pragma once

// Small meshes and bodies of them, through the C API: owners and conversions. No test logic.

#include "capi/polyhedra.h"
#include "capi/world_fixture.h"

namespace halfspace_test {

struct DestroyMesh {
  void operator()(hs_mesh* mesh) const { hs_mesh_destroy(mesh); }
};
using Mesh = std::unique_ptr<hs_mesh, DestroyMesh>;

/// Nodes and cells as the API takes them.
struct MeshWords {
  int dimension = 2;
  Points3 nodes;
  std::vector<std::int32_t> kinds;
  std::vector<std::int32_t> cell_nodes;

  MeshWords& add_cell(std::int32_t kind, std::initializer_list<std::int32_t> names) {
    kinds.push_back(kind);
    cell_nodes.insert(cell_nodes.end(), names);
    return *this;
  }
};

inline hs_status create_mesh(hs_context* context, const MeshWords& words, hs_mesh** mesh) {
  return hs_mesh_create(context, words.dimension, view_of(words.nodes), words.kinds.data(),
                        std::int64_t(words.kinds.size()), words.cell_nodes.data(),
                        std::int64_t(words.cell_nodes.size()), mesh);
}

inline Mesh make_mesh(hs_context* context, const MeshWords& words) {
  hs_mesh* mesh = nullptr;
  require_ok(create_mesh(context, words, &mesh), context);
  return Mesh(mesh);
}

/// Cells of all kinds of the dimension, from the origin along x: in the plane a square and the two triangles
/// of another one; in space a cube, the two prisms of another one, and a tetrahedron on top of these.
inline MeshWords bar(int dimension, double size = 1) {
  MeshWords words;
  words.dimension = dimension;
  for (int layer = 0; layer < dimension - 1; ++layer)
    for (const double y : {0.0, 1.0})
      for (const double x : {0.0, 1.0, 2.0}) words.nodes.push_back({x, y, double(layer)});
  if (dimension == 2) {
    words.add_cell(HS_CELL_QUAD, {0, 1, 4, 3});
    words.add_cell(HS_CELL_TRIANGLE, {1, 2, 5}).add_cell(HS_CELL_TRIANGLE, {1, 5, 4});
  } else {
    words.nodes.push_back({1.4, 0.7, 1.6});
    words.add_cell(HS_CELL_HEXAHEDRON, {0, 1, 4, 3, 6, 7, 10, 9});
    words.add_cell(HS_CELL_PRISM, {1, 2, 5, 7, 8, 11}).add_cell(HS_CELL_PRISM, {1, 5, 4, 7, 11, 10});
    words.add_cell(HS_CELL_TETRAHEDRON, {7, 11, 10, 12});
  }
  for (Point3& node : words.nodes) node = {size * node.x, size * node.y, size * node.z};
  return words;
}

inline hs_body_def body_def(const hs_pose& pose = pose_at(0, 0)) {
  hs_body_def def;
  if (hs_body_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no body definition");
  def.pose = pose;
  return def;
}

inline hs_body add_body(hs_context* context, hs_world* world, const MeshWords& words,
                        const hs_body_def& def) {
  const Mesh mesh = make_mesh(context, words);
  hs_body body = 0;
  require_ok(hs_world_add_mesh(world, mesh.get(), &def, nullptr, &body), context);
  return body;
}

inline hs_body_state state_of_body(const hs_world* world, hs_body body) {
  hs_body_state state{};
  if (hs_world_get_body_state(world, body, &state, sizeof state) != HS_OK)
    throw std::runtime_error("no body state");
  return state;
}

using NodeGetter = decltype(&hs_world_get_node_positions);

/// The vectors that one of the getters of nodes writes.
inline Points3 of_nodes(NodeGetter get, const hs_world* world, hs_body body) {
  Points3 points(std::size_t(state_of_body(world, body).node_count));
  if (get(world, body, mutable_view_of(points), nullptr) != HS_OK) throw std::runtime_error("no nodes");
  return points;
}

constexpr std::int32_t all_laws[] = {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL,
                                     HS_STIFFNESS_NONE};

inline hs_bond_def bond_def(double stiffness, double strength) {
  hs_bond_def def;
  if (hs_bond_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no bond definition");
  def.normal_stiffness = stiffness;
  def.tensile_strength = def.cohesion = strength;
  return def;
}

inline std::vector<hs_bond> bonds_of(const hs_world* world) {
  std::int64_t count = 0;
  (void)hs_world_get_bonds(world, nullptr, 0, &count);
  std::vector<hs_bond> bonds(static_cast<std::size_t>(count));
  if (hs_world_get_bonds(world, bonds.data(), count, nullptr) != HS_OK) throw std::runtime_error("no bonds");
  return bonds;
}

inline std::vector<hs_bond_event> bond_events_of(const hs_world* world) {
  std::int64_t count = 0;
  (void)hs_world_get_bond_events(world, 0, nullptr, 0, &count);
  std::vector<hs_bond_event> events(static_cast<std::size_t>(count));
  if (hs_world_get_bond_events(world, 0, events.data(), count, nullptr) != HS_OK)
    throw std::runtime_error("no bond events");
  return events;
}

inline hs_relaxation_def relaxation_def(std::int64_t max_steps, double ratio) {
  hs_relaxation_def def;
  if (hs_relaxation_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no relaxation definition");
  def.max_steps = max_steps;
  def.ratio = ratio;
  return def;
}

}  // namespace halfspace_test
