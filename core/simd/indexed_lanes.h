#pragma once

#include "simd/four_lanes.h"
#include "simd/two_lanes.h"

namespace halfspace {

/// Values, each with the index of its vertex, edge or face. Indices are integers stored as doubles.
template <class Lanes>
struct Indexed {
  Lanes value;
  Lanes index;
};

using IndexedLanes = Indexed<TwoLanes>;

/// The larger (smaller) value of each lane, with its index. Without branches, as they would be unpredictable.
inline IndexedLanes max(const IndexedLanes& a, const IndexedLanes& b) {
  return {max(a.value, b.value), b.value > a.value ? b.index : a.index};
}
template <class Lanes>
[[gnu::always_inline]] inline Indexed<Lanes> min(const Indexed<Lanes>& a, const Indexed<Lanes>& b) {
  return {select_less(b.value, a.value, b.value, a.value), select_less(b.value, a.value, b.index, a.index)};
}

/// The minimum of all lanes, with its index.
template <class Four>
[[gnu::always_inline]] inline IndexedLanes reduce_min(const Indexed<Four>& a) {
  const IndexedLanes two = min(IndexedLanes{low_half(a.value), low_half(a.index)},
                               IndexedLanes{high_half(a.value), high_half(a.index)});
  return min(two, {exchanged(two.value), exchanged(two.index)});
}

}  // namespace halfspace
