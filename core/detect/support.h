#pragma once

#include <algorithm>

#include "detect/indexed_lanes.h"
#include "geometry/outline.h"

namespace halfspace {

/// A vertex of a polyhedron and how far it lies along some direction.
struct Support {
  double height;
  int vertex;
};

/// The vertex that lies deepest along a direction: with an outer normal of the other block's half-space it
/// forms a potential contact pair (Wang et al. 2021, eq. 17). Two vertices at a time, and selections instead
/// of branches: which vertex it is is as good as random.
inline Support deepest_among_all(const Outline<3>& block, const Vector<3>& direction) {
  const TwoLanes nx = both(direction.x()), ny = both(direction.y()), nz = both(direction.z());
  const auto heights_at = [&](int v) {
    return nx * two_at(block.x + v) + ny * two_at(block.y + v) + nz * two_at(block.z + v);
  };
  // Padded to a multiple of four: two chains of comparisons, neither of which waits for the other.
  TwoLanes even_index = {0, 1}, odd_index = {2, 3};
  IndexedLanes even = {heights_at(0), even_index}, odd = {heights_at(2), odd_index};
  for (int v = 4; v < block.vertex_count(); v += 4) {
    even_index += both(4);
    odd_index += both(4);
    even = smaller(even, {heights_at(v), even_index});
    odd = smaller(odd, {heights_at(v + 2), odd_index});
  }
  const IndexedLanes deepest = smaller(even, odd);
  const IndexedLanes least = smaller(deepest, {exchanged(deepest.value), exchanged(deepest.index)});
  return {least.value[0],
          std::min(int(least.index[0]), block.vertex_count() - 1)};  // padding repeats the last
}

/// The same for a block of many vertices, by a walk over its edges from a vertex near it; or from the deepest
/// of some that are spread over the block.
Support walk_to_deepest(const Outline<3>& block, const Vector<3>& direction, int hint);
Support walk_to_deepest(const Outline<3>& block, const Vector<3>& direction);

/// Up to this many vertices, to look at all is faster than to walk (tests/benchmarks, bench_pairs_3d).
constexpr int few_vertices = 48;

/// The same, by whichever is faster; `hint` is where to look first.
inline Support deepest(const Outline<3>& block, const Vector<3>& direction, int hint) {
  return block.vertex_count() <= few_vertices ? deepest_among_all(block, direction)
                                              : walk_to_deepest(block, direction, hint);
}
inline Support deepest(const Outline<3>& block, const Vector<3>& direction) {
  return block.vertex_count() <= few_vertices ? deepest_among_all(block, direction)
                                              : walk_to_deepest(block, direction);
}

}  // namespace halfspace
