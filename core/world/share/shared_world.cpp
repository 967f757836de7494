#include "world/share/shared_world.h"

#include <algorithm>
#include <limits>

#include "geometry/precise.h"

namespace halfspace {
namespace {

/// A sum beside that of its rounding errors: in any order of the terms accurate to the rounding of the result
/// [Dekker 1971].
template <class Value>
struct AccurateSum {
  Value rounded = Value::Zero();
  Value errors = Value::Zero();

  void add(const Value& term) {
    for (int i = 0; i < Value::SizeAtCompileTime; ++i) {
      const Precise sum = difference(rounded[i], -term[i]);
      rounded[i] = sum.high;
      errors[i] += sum.low;
    }
  }
  Value value() const { return rounded + errors; }
};

}  // namespace

template <int D>
void set_keys(State<D>& state, std::span<const std::int64_t> keys) {
  const Blocks<D>& blocks = state.model.blocks;
  Array<std::int64_t> of_slots(blocks.kind.get_allocator());
  of_slots.reserve(blocks.slot_count());
  std::int64_t last = std::numeric_limits<std::int64_t>::min();  // free slots repeat the key before
  auto next = keys.begin();
  for (std::size_t i = 0; i < blocks.slot_count(); ++i)
    of_slots.push_back(last = blocks.lives(i) ? *next++ : last);
  state.share.set_keys(of_slots);
}

template <int D>
std::int32_t living_slot_of(const State<D>& state, std::int64_t key, std::size_t near) {
  const std::int32_t slot = state.share.slot_of(key, state.model.blocks.slot_count(), near);
  return slot >= 0 && state.model.blocks.lives(std::size_t(slot)) ? slot : -1;
}

template <int D>
Share::Common common_of_shares(State<D>& state) {
  if (!state.share.is_whole()) return state.share.common();
  const Blocks<D>& blocks = state.model.blocks;
  std::size_t first = 0;
  while (first < blocks.slot_count() && !blocks.moves_freely(first)) ++first;
  return {blocks.count(), first < blocks.slot_count() ? state.share.key_of(first) : -1,
          state.contacts.neighbors().median_radius(blocks)};
}

template <int D>
Momentum<D> momentum_of(const State<D>& state) {
  const Blocks<D>& blocks = state.model.blocks;
  AccurateSum<Vector<D>> linear;
  AccurateSum<Angular<D>> angular;
  for (std::size_t i = 0; i < blocks.slot_count(); ++i) {
    if (!blocks.moves_freely(i) || !state.share.is_own(i) || blocks.is_part(i) || blocks.is_of_mesh(i))
      continue;
    const Vector<D> of_block = blocks.mass[i] * blocks.velocity[i];
    linear.add(of_block);
    angular.add(moment(blocks.position[i], of_block));
    angular.add(blocks.momentum[i]);
  }
  return {linear.value(), angular.value()};
}

/// Two pairs of the list away: Share says why. A pair holds blocks whose gap is at most both skins when the
/// list is made, and each moves by its skin while the list is in use.
template <int D>
double halo(State<D>& state) {
  const Blocks<D>& blocks = state.model.blocks;
  NeighborList<D>& neighbors = state.contacts.neighbors();
  const double typical = common_of_shares(state).typical_radius;
  double reach = 0;
  for (std::size_t i = 0; i < blocks.slot_count(); ++i) {
    if (!blocks.moves_freely(i)) continue;
    const double usual = state.model.settings.skin * 2 * std::min(blocks.radius[i], typical);
    const double announced = i < neighbors.list_length() ? neighbors.announced_motion(i) : 0;
    reach = std::max(reach, blocks.radius[i] + 2 * std::max({usual, announced, neighbors.skin_of(i)}));
  }
  return 4 * reach;
}

#define HALFSPACE_FUNCTIONS(D)                                                      \
  template void set_keys(State<D>&, std::span<const std::int64_t>);                 \
  template std::int32_t living_slot_of(const State<D>&, std::int64_t, std::size_t); \
  template Share::Common common_of_shares(State<D>&);                               \
  template double halo(State<D>&);                                                  \
  template Momentum<D> momentum_of(const State<D>&);

HALFSPACE_FUNCTIONS(2)
HALFSPACE_FUNCTIONS(3)
#undef HALFSPACE_FUNCTIONS

}  // namespace halfspace
