#pragma once

#include "geometry/two_lanes.h"

namespace halfspace {

/// Values, and the index of the edge or vertex that each is of. Whole numbers, as doubles.
struct IndexedLanes {
  TwoLanes value;
  TwoLanes index;
};

/// Lane by lane, the one of the larger (smaller) value. Without branches: which one wins is as good as
/// random.
inline IndexedLanes larger(const IndexedLanes& a, const IndexedLanes& b) {
  return {larger(a.value, b.value), b.value > a.value ? b.index : a.index};
}
inline IndexedLanes smaller(const IndexedLanes& a, const IndexedLanes& b) {
  return {smaller(a.value, b.value), b.value < a.value ? b.index : a.index};
}

}  // namespace halfspace
