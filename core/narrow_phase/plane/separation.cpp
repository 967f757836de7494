#include "narrow_phase/plane/separation.h"

#include "narrow_phase/plane/potential_pairs.h"

// Polygons of many vertices: the half-spaces of both outlines, sorted by direction, merge to the outline of
// the Minkowski difference. Each is a potential pair with the vertex that the merge has reached
// (docs/theory.md), so that all pairs are visited in count_a + count_b steps. The largest gap decides; one
// above the margin ends the search. Others are tested by all combinations (separation.h).

namespace halfspace {

int walk_to_deepest_vertex(const Outline<2>& block, const Vector<2>& normal, int hint) {
  // Heights along a convex outline have one minimum: walk downhill, in one direction or the other.
  int deepest = hint;
  double least = height_along(normal, block, hint);
  const auto walk = [&](auto neighbour) {
    for (int v = neighbour(hint); height_along(normal, block, v) < least; v = neighbour(v)) {
      deepest = v;
      least = height_along(normal, block, v);
    }
  };
  walk([&](int v) { return block.next(v); });
  if (deepest == hint) walk([&](int v) { return block.previous(v); });
  // Below the centroid the descent is steep; above it, on a blunt top, the walk may stop at once.
  return least < 0 ? deepest : deepest_vertex(block, normal);
}

Separation<2> find_separation_by_merge(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                                       double margin) {
  Separation<2> best{-HUGE_VAL, {}};
  for_each_potential_pair(a, b, [&](const PotentialPair<2>& pair) {
    const double gap = pair.owner == 0 ? edge_gap(a, pair.edge, b, pair.vertex, to_b)
                                       : edge_gap(b, pair.edge, a, pair.vertex, -to_b);
    if (gap > best.gap) best = {gap, pair};
    return best.gap <= margin;
  });
  return best;
}

}  // namespace halfspace
