#pragma once

#include <cstdint>
#include <span>

#include "world/stages/state.h"

namespace halfspace {

// Keys, common properties and sums of a world and its shares, and how far copies reach.

/// Names the living blocks, in ascending order.
template <int D>
void set_keys(State<D>& state, std::span<const std::int64_t> keys);

/// The slot of the block with a key; -1: none. `near`: a slot that may be a little before it.
template <int D>
std::int32_t living_slot_of(const State<D>& state, std::int64_t key, std::size_t near = 0);

/// The properties that all shares of this world have, or of the world of which it is a share.
template <int D>
Share::Common common_of_shares(State<D>& state);

/// Twice the largest distance of the centroids of two blocks that the next list may hold.
template <int D>
double halo(State<D>& state);

/// The momentum of the own blocks of a share; those of meshes are not among them.
template <int D>
struct Momentum {
  Vector<D> linear = Vector<D>::Zero();     // N s
  Angular<D> angular = Angular<D>::Zero();  // about the origin, N m s
};

template <int D>
Momentum<D> momentum_of(const State<D>& state);

/// Sets the ledger of a share to the sums over all shares.
template <int D>
void set_ledger_sums(State<D>& state, const EnergyLedger::Sums& sums) {
  state.ledger.set_sums(sums);
  state.share.take_all_losses();
}

}  // namespace halfspace
