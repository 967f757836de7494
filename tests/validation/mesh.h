#pragma once

// Bodies of finite elements, for tests that bend them and look at what comes of it.

#include "capi/mesh_words.h"
#include "validation/affine.h"

namespace halfspace_test {

/// Springs without dashpots, so stiff on each unit of area.
inline hs_law_def area_law(double stiffness, double friction_angle = 0) {
  hs_law_def law = spring_law(stiffness, friction_angle);
  law.stiffness_kind = HS_STIFFNESS_PER_AREA;
  return law;
}

/// A world with one material, for bodies of it.
class MeshScene : public SolidScene {
 public:
  MeshScene(const hs_world_def& def, const hs_law_def& law, double density, const Elastic& elastic)
      : SolidScene(def, law, density) {
    set_elastic(*this, elastic);
  }

  hs_body add_mesh(const MeshWords& words, const Triple& place = {}, const Triple& velocity = {}) const {
    hs_body_def def;
    check(hs_body_def_init(&def, sizeof def));
    for (std::size_t k = 0; k < 3; ++k) {
      def.pose.position[k] = place[k];
      def.velocity[k] = velocity[k];
    }
    hs_body body = 0;
    check(hs_world_add_mesh(world(), make_mesh(context(), words).get(), &def, nullptr, &body));
    return body;
  }

  hs_body_state body_state(hs_body body) const {
    hs_body_state state;
    check(hs_world_get_body_state(world(), body, &state, sizeof state));
    return state;
  }
  Nodes positions(hs_body body) const { return read(hs_world_get_node_positions, body); }
  Nodes velocities(hs_body body) const { return read(hs_world_get_node_velocities, body); }
  Nodes forces(hs_body body) const { return read(hs_world_get_node_forces, body); }

  std::vector<hs_cell_state> cells(hs_body body) const {
    std::vector<hs_cell_state> cells(std::size_t(body_state(body).cell_count));
    check(hs_world_get_cells(world(), body, cells.data(), std::int64_t(cells.size()), nullptr));
    return cells;
  }

  void set_velocities(hs_body body, const Nodes& velocities) const {
    check(hs_world_set_node_velocities(world(), body, view_of(velocities)));
  }
  void hold(hs_body body, const std::vector<int32_t>& nodes, int32_t axes,
            const Triple& velocity = {}) const {
    check(
        hs_world_hold_nodes(world(), body, nodes.data(), std::int64_t(nodes.size()), axes, velocity.data()));
  }
  void push(hs_body body, const std::vector<int32_t>& nodes, const Triple& force) const {
    check(hs_world_set_node_force(world(), body, nodes.data(), std::int64_t(nodes.size()), force.data()));
  }

  /// Those nodes of a body for which it holds.
  template <class Holds>
  std::vector<int32_t> nodes_where(hs_body body, Holds holds) const {
    std::vector<int32_t> names;
    const Nodes nodes = positions(body);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (holds(nodes[i])) names.push_back(int32_t(i));
    }
    return names;
  }

 private:
  template <class Get>
  Nodes read(Get get, hs_body body) const {
    Nodes nodes(std::size_t(body_state(body).node_count));
    const hs_mutable_view view{&nodes[0].x(), &nodes[0].y(), &nodes[0].z(), sizeof(Node),
                               std::int64_t(nodes.size())};
    check(get(world(), body, view, nullptr));
    return nodes;
  }
};

/// Over the mass of a node in one cell: all cells are equal, and their nodes share their mass equally.
inline double angular_momentum(const MeshWords& words, const Nodes& places, const Nodes& velocities) {
  double momentum = 0;
  for (const int32_t node : words.cell_nodes)
    momentum += places[std::size_t(node)].cross(velocities[std::size_t(node)]).z();
  return momentum;
}

inline hs_balance relax(const Scene& scene, double ratio) {
  hs_relaxation_def def;
  hs_relaxation_def_init(&def, sizeof def);
  def.ratio = ratio;
  hs_balance balance;
  scene.check(hs_world_relax(scene.world(), &def, &balance, sizeof balance));
  return balance;
}

inline hs_world_def mesh_world_def(int dimension, double mass_damping = 0) {
  hs_world_def def = dimension == 2 ? world_def(0, 0) : solid_world_def(0, {0, 0, 0});
  def.mass_damping = mass_damping;
  return def;
}

}  // namespace halfspace_test
