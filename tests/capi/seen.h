#pragma once

// All that can be read of a scene, as bytes to compare.

#include <utility>

#include "capi/entry_points.h"

namespace halfspace_test {

template <class T>
void append(std::vector<unsigned char>& bytes, const T* values, std::size_t count) {
  const auto* first = reinterpret_cast<const unsigned char*>(values);
  bytes.insert(bytes.end(), first, first + count * sizeof(T));
}

/// All that a caller can read of a scene without changing it. Contacts are written whole, states have no
/// padding.
inline std::vector<unsigned char> seen(const Scene& scene) {
  const hs_world* world = scene.world.get();
  std::vector<unsigned char> bytes;
  append(bytes, &scene.written, 1);
  const std::vector<hs_contact> contacts = contacts_of(world);
  append(bytes, contacts.data(), contacts.size());
  const std::vector<hs_bond> bonds = bonds_of(world);
  append(bytes, bonds.data(), bonds.size());
  if (scene.body != 0) {
    for (const auto get :
         {hs_world_get_node_positions, hs_world_get_node_velocities, hs_world_get_node_forces}) {
      const Points3 nodes = of_nodes(get, world, scene.body);
      append(bytes, nodes.data(), nodes.size());
    }
  }
  hs_block blocks[64];
  std::int64_t count = 0;
  if (hs_world_get_blocks(world, blocks, 64, &count) != HS_OK) throw std::runtime_error("no blocks");
  append(bytes, blocks, std::size_t(count));
  for (std::int64_t i = 0; i < count; ++i) {
    const hs_block_state state = state_of(world, blocks[i]);
    append(bytes, &state, 1);
  }
  return bytes;
}

}  // namespace halfspace_test
