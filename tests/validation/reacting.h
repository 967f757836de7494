#pragma once

// Bodies of finite elements that meet by a law without a spring.

#include "validation/mesh.h"

namespace halfspace_test {

inline hs_law_def law_without_spring(double friction_angle = 0) {
  hs_law_def law;
  hs_law_def_init(&law, sizeof law);
  law.stiffness_kind = HS_STIFFNESS_NONE;
  law.friction_angle = friction_angle;
  return law;
}

class ReactingScene : public MeshScene {
 public:
  using MeshScene::MeshScene;

  hs_body body_of(hs_block block) const {
    hs_body body = 0;
    check(hs_world_get_body_of_block(world(), block, &body, nullptr));
    return body;
  }
  /// The sum of all forces on a body. That of a touch in the last step is a blow.
  Node force_on(hs_body body) const {
    Node force = Node::Zero();
    for (const hs_contact& contact : contacts()) {
      if (body_of(contact.block_b) == body) force += Eigen::Map<const Node>(contact.force);
      if (body_of(contact.block_a) == body) force -= Eigen::Map<const Node>(contact.force);
    }
    return force;
  }
  Node force_on_block(hs_block block) const {
    Node force = Node::Zero();
    for (const hs_contact& contact : contacts()) {
      if (contact.block_b == block) force += Eigen::Map<const Node>(contact.force);
      if (contact.block_a == block) force -= Eigen::Map<const Node>(contact.force);
    }
    return force;
  }
  double speed(hs_body body, int axis = 0) const {
    const hs_body_state state = body_state(body);
    return state.momentum[axis] / state.mass;
  }
  /// Kinetic, of strain and of weight.
  double energy_present() const {
    const hs_world_report report = this->report();
    return report.energy.kinetic + report.energy.gravity + report.block_strain_energy;
  }
};

/// An equilateral triangle that points along x, of edges cut into so many parts; its tip is at the origin.
inline MeshWords pointed_triangle(double edge, int parts) {
  MeshWords words;
  std::vector<std::vector<int32_t>> rows;
  const Node back(-edge * std::sqrt(0.75), -0.5 * edge, 0), up(0, edge / parts, 0);
  for (int i = 0; i <= parts; ++i) {
    const Node first = back * (1 - double(i) / parts);
    rows.emplace_back();
    for (int k = 0; k <= parts - i; ++k) {
      rows.back().push_back(int32_t(words.nodes.size()));
      words.nodes.push_back(first + k * up);
    }
  }
  for (std::size_t i = 0; i < std::size_t(parts); ++i) {
    for (std::size_t k = 0; k + i < std::size_t(parts); ++k) {
      words.add_cell(HS_CELL_TRIANGLE, {rows[i][k], rows[i + 1][k], rows[i][k + 1]});
      if (k + i + 1 < std::size_t(parts))
        words.add_cell(HS_CELL_TRIANGLE, {rows[i + 1][k], rows[i + 1][k + 1], rows[i][k + 1]});
    }
  }
  return words;
}

}  // namespace halfspace_test
