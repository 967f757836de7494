#pragma once

// Bonds, for tests that make them and look at what comes of it.

#include "validation/mesh.h"

namespace halfspace_test {

inline hs_bond_def bond_def(double stiffness) {
  hs_bond_def def;
  hs_bond_def_init(&def, sizeof def);
  def.normal_stiffness = stiffness;
  return def;
}

inline hs_bond_def strong_bond(double stiffness) {
  hs_bond_def def = bond_def(stiffness);
  def.tensile_strength = def.cohesion = 1e30;
  return def;
}

inline std::int64_t bond_all(const MeshScene& scene, const hs_bond_def& def) {
  std::int64_t count = 0;
  scene.check(hs_world_bond_materials(scene.world(), 0, 0, &def, &count));
  return count;
}

inline std::vector<hs_bond> bonds_of(const MeshScene& scene) {
  std::int64_t count = 0;
  REQUIRE(hs_world_get_bonds(scene.world(), nullptr, 0, &count) >= HS_OK);
  std::vector<hs_bond> bonds(static_cast<std::size_t>(count));
  scene.check(hs_world_get_bonds(scene.world(), bonds.data(), count, nullptr));
  return bonds;
}

inline std::vector<hs_bond_event> events_of(const MeshScene& scene) {
  std::int64_t count = 0;
  REQUIRE(hs_world_get_bond_events(scene.world(), 0, nullptr, 0, &count) >= HS_OK);
  std::vector<hs_bond_event> events(static_cast<std::size_t>(count));
  scene.check(hs_world_get_bond_events(scene.world(), 0, events.data(), count, nullptr));
  return events;
}

inline hs_bond_report bond_report(const MeshScene& scene) {
  hs_bond_report report;
  scene.check(hs_world_get_bond_report(scene.world(), &report, sizeof report));
  return report;
}

/// The same cells, of which none shares a node with another.
inline MeshWords taken_apart(const MeshWords& words) {
  MeshWords apart = words;
  apart.nodes.clear();
  for (std::int32_t& node : apart.cell_nodes) {
    apart.nodes.push_back(words.nodes[std::size_t(node)]);
    node = int32_t(apart.nodes.size()) - 1;
  }
  return apart;
}

}  // namespace halfspace_test
