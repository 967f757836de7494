#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/outline.h"
#include "geometry/polyhedron/gauss_map.h"
#include "geometry/support.h"
#include "simd/indexed_lanes.h"

namespace halfspace {

/// The deepest vertex along a direction: with an outer normal of the other block's half-space it is a
/// potential contact pair (Wang et al. 2021, eq. 19). Eight vertices at a time, in two independent chains of
/// four, with selections instead of branches, as the vertex is unpredictable.
template <class Four = TwiceTwoLanes>
[[gnu::always_inline]] inline Support deepest_among_all(const Outline<3>& block, const Vector<3>& direction) {
  const Four nx = all_four<Four>(direction.x()), ny = all_four<Four>(direction.y()),
             nz = all_four<Four>(direction.z()), eight = all_four<Four>(8);
  const auto heights = [&](int v) __attribute__((always_inline)) {
    return nx * load_four<Four>(block.x + v) + ny * load_four<Four>(block.y + v) +
           nz * load_four<Four>(block.z + v);
  };
  Four even = four_of<Four>(0, 1, 2, 3), odd = four_of<Four>(4, 5, 6, 7);
  Indexed<Four> deepest_even = {all_four<Four>(HUGE_VAL), even},
                deepest_odd = {all_four<Four>(HUGE_VAL), odd};
  int v = 0;
  for (; v + 4 < block.vertex_count(); v += 8) {
    deepest_even = min(deepest_even, {heights(v), even});
    deepest_odd = min(deepest_odd, {heights(v + 4), odd});
    even = even + eight;
    odd = odd + eight;
  }
  if (v < block.vertex_count()) deepest_even = min(deepest_even, {heights(v), even});
  const IndexedLanes least = reduce_min(min(deepest_even, deepest_odd));
  return {least.value[0],
          std::min(int(least.index[0]), block.vertex_count() - 1)};  // padding repeats the last
}

/// The same for a block with a Gauss map.
[[gnu::always_inline]] inline Support deepest_on_map(const Outline<3>& block, const Vector<3>& direction) {
  Support deepest{HUGE_VAL, 0};
  for (const int v : block.gauss_map->candidates(direction)) {
    const double height =
        direction.x() * block.x[v] + direction.y() * block.y[v] + direction.z() * block.z[v];
    deepest = {std::min(height, deepest.height), height < deepest.height ? v : deepest.vertex};
  }
  return deepest;
}

/// The same by the fastest method; `hint` is the start of a walk.
template <class Four = TwiceTwoLanes>
[[gnu::always_inline]] inline Support deepest(const Outline<3>& block, const Vector<3>& direction, int hint) {
  if (block.vertex_count() <= few_vertices) return deepest_among_all<Four>(block, direction);
  return block.gauss_map ? deepest_on_map(block, direction) : walk_to_deepest(block, direction, hint);
}
template <class Four = TwiceTwoLanes>
[[gnu::always_inline]] inline Support deepest(const Outline<3>& block, const Vector<3>& direction) {
  if (block.vertex_count() <= few_vertices) return deepest_among_all<Four>(block, direction);
  return block.gauss_map ? deepest_on_map(block, direction) : walk_to_deepest(block, direction);
}

/// The height of the deepest vertex, without its index: half the cost.
template <class Four>
[[gnu::always_inline]] inline double min_height(const Outline<3>& block, const Vector<3>& direction) {
  const Four nx = all_four<Four>(direction.x()), ny = all_four<Four>(direction.y()),
             nz = all_four<Four>(direction.z());
  const auto heights = [&](int v) __attribute__((always_inline)) {
    return nx * load_four<Four>(block.x + v) + ny * load_four<Four>(block.y + v) +
           nz * load_four<Four>(block.z + v);
  };
  Four least = all_four<Four>(HUGE_VAL);
  // This order of arguments ignores NaN.
  for (int v = 0; v < block.vertex_count(); v += 4) least = min(heights(v), least);
  return reduce_min(least);
}

}  // namespace halfspace
