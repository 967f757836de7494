#pragma once

#include <algorithm>
#include <cmath>

#include "detect/indexed_lanes.h"
#include "geometry/deepest_vertex.h"
#include "geometry/gauss_map.h"
#include "geometry/outline.h"

namespace halfspace {

/// The vertex that lies deepest along a direction: with an outer normal of the other block's half-space it
/// forms a potential contact pair (Wang et al. 2021, eq. 17). Four vertices at a time, and selections instead
/// of branches: which vertex it is is as good as random.
template <class Four = TwiceTwoLanes>
[[gnu::always_inline]] inline Support deepest_among_all(const Outline<3>& block, const Vector<3>& direction) {
  const Four nx = all_four<Four>(direction.x()), ny = all_four<Four>(direction.y()),
             nz = all_four<Four>(direction.z());
  Four index = four_of<Four>(0, 1, 2, 3);
  Indexed<Four> deepest = {all_four<Four>(HUGE_VAL), index};
  for (int v = 0; v < block.vertex_count(); v += 4) {
    const Four height =
        nx * four_at<Four>(block.x + v) + ny * four_at<Four>(block.y + v) + nz * four_at<Four>(block.z + v);
    deepest = smaller(deepest, {height, index});
    index = index + all_four<Four>(4);
  }
  const IndexedLanes least = smallest(deepest);
  return {least.value[0],
          std::min(int(least.index[0]), block.vertex_count() - 1)};  // padding repeats the last
}

/// The same for a block that has a map of what is deepest.
[[gnu::always_inline]] inline Support deepest_on_map(const Outline<3>& block, const Vector<3>& direction) {
  Support deepest{HUGE_VAL, 0};
  for (const int v : block.gauss_map->candidates(direction)) {
    const double height =
        direction.x() * block.x[v] + direction.y() * block.y[v] + direction.z() * block.z[v];
    deepest = {std::min(height, deepest.height), height < deepest.height ? v : deepest.vertex};
  }
  return deepest;
}

/// The same, by whichever is faster; `hint` is where to look first.
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

}  // namespace halfspace
