#include "world/world.h"

namespace halfspace {

template <int D>
std::int32_t World<D>::add_table(std::span<const double> times, std::span<const Vector<3>> values) {
  return model_.actions.add_table(times, values);
}

template <int D>
void World<D>::add_action(const Action<D>& action) {
  model_.actions.add(action);
  state_.edit();
}

template <int D>
void World<D>::add_node_action(const NodeAction& action, std::span<const std::int32_t> nodes,
                               std::span<const Vector<D>> scales) {
  model_.actions.add(action, nodes, scales);
  state_.edit();
}

template <int D>
void World<D>::end_actions(std::int32_t slot) {
  model_.actions.end_on_block(slot, model_.blocks);
  state_.edit();
}

template <int D>
void World<D>::end_node_actions(std::int32_t body) {
  model_.actions.end_on_nodes(body, model_.blocks);
  state_.edit();
}

template <int D>
void World<D>::hold_block(std::int32_t slot, std::uint8_t components) {
  model_.blocks.hold(std::size_t(slot), components);
  state_.edit();
}

/// The work on the contacts of the block continues with the new velocity.
template <int D>
void World<D>::prescribe_velocity(std::int32_t slot, const Vector<D>& velocity, const Angular<D>& spin) {
  Blocks<D>& blocks = model_.blocks;
  const std::size_t s = std::size_t(slot);
  if (velocity == blocks.velocity[s] && spin == blocks.spin[s]) return;
  state_.drop_shared_motion();
  if (!state_.is_edited()) {
    state_.ledger.add_outer_power(blocks.force[s].dot(blocks.velocity[s] - velocity) +
                                  blocks.torque[s].dot(blocks.spin[s] - spin));
  }
  blocks.set_motion(slot, velocity, spin);
  state_.sleep.wake_all(state_.clock.time());
}

#define HALFSPACE_MEMBERS(D)                                                                      \
  template std::int32_t World<D>::add_table(std::span<const double>, std::span<const Vector<3>>); \
  template void World<D>::add_action(const Action<D>&);                                           \
  template void World<D>::add_node_action(const NodeAction&, std::span<const std::int32_t>,       \
                                          std::span<const Vector<D>>);                            \
  template void World<D>::end_actions(std::int32_t);                                              \
  template void World<D>::end_node_actions(std::int32_t);                                         \
  template void World<D>::hold_block(std::int32_t, std::uint8_t);                                 \
  template void World<D>::prescribe_velocity(std::int32_t, const Vector<D>&, const Angular<D>&);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
