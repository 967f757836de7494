#pragma once

#include <cmath>
#include <cstdint>

#include "detect/contact.h"
#include "detect/two_lanes.h"
#include "geometry/outline.h"
#include "geometry/rotation.h"

namespace halfspace {

/// A violated potential pair, or the pair of least depth when none is violated, its gap and the normal of its
/// half-space, turned so that it points from a to b, in the frame of a.
struct Separation {
  double gap;
  PotentialPair pair;
  Vector<2> normal;
};

/// The turn from a frame into itself.
struct NoTurn {
  NoTurn inverse() const { return {}; }
  template <class Direction>
  const Direction& operator*(const Direction& direction) const {
    return direction;
  }
};

/// Two directions in the plane, side by side.
struct DirectionLanes {
  TwoLanes x;
  TwoLanes y;
};

inline DirectionLanes operator*(const Rotation<2>& turn, const DirectionLanes& d) {
  const TwoLanes c = both(turn.cosine), s = both(turn.sine);
  return {c * d.x - s * d.y, s * d.x + c * d.y};
}

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

inline double height_along(const Vector<2>& normal, const Outline<2>& block, int vertex) {
  return normal.x() * block.x[vertex] + normal.y() * block.y[vertex];
}

/// The vertex that lies deepest along the outer normal of the other block's half-space, that is the vertex
/// which forms a potential contact pair with it (Wang et al. 2021, eq. 9): both its neighbours lie farther
/// out. Two vertices at a time, and selections instead of branches: which vertex it is is as good as random.
inline int deepest_vertex(const Outline<2>& block, const Vector<2>& normal) {
  const TwoLanes nx = both(normal.x()), ny = both(normal.y());
  const auto heights_at = [&](int v) { return nx * two_at(block.x + v) + ny * two_at(block.y + v); };
  TwoLanes vertex = {0, 1};
  IndexedLanes deepest = {heights_at(0), vertex};
  for (int v = 2; v < block.count; v += 2) {
    vertex += both(2);
    deepest = smaller(deepest, {heights_at(v), vertex});
  }
  return int(smaller(deepest, {exchanged(deepest.value), exchanged(deepest.index)}).index[0]);
}

/// The same for a block of many vertices, by a walk from a vertex near it.
int walk_to_deepest_vertex(const Outline<2>& block, const Vector<2>& normal, int hint);

/// The same, by whichever is faster; `hint` is where to look first.
inline int deepest_vertex(const Outline<2>& block, const Vector<2>& normal, int hint) {
  constexpr int few = 12;
  return block.count <= few ? deepest_vertex(block, normal) : walk_to_deepest_vertex(block, normal, hint);
}

/// Gap of an edge: distance of the other block's deepest vertex from the half-space, below 0 when it is
/// inside (eq. 10). `to_other` leads from the owner's centroid to the other's.
inline double edge_gap(const Outline<2>& owner, int edge, const Outline<2>& other, int vertex,
                       const Vector<2>& to_other) {
  const Vector<2> normal = owner.normal(edge);
  return (normal.dot(other.vertex(vertex)) + normal.dot(to_other)) - owner.offset[edge];
}

// What follows is inlined by force: called, it would hand its lanes over through memory, in the chain of
// operations that the first branch on a pair waits for.

/// The largest gap among the even edges of `owner`, and that among its odd ones, by all combinations with the
/// other's vertices. Of the other's arrays only the vertices are read. Both are seen from the frame of the
/// other: the owner's directions are turned into it, and `to_other` leads there from the owner's centroid to
/// the other's.
template <class Turn>
[[gnu::always_inline]] inline IndexedLanes largest_gaps(const Outline<2>& owner, const Outline<2>& other,
                                                        const Turn& turn, const Vector<2>& to_other) {
  const TwoLanes to_x = both(to_other.x()), to_y = both(to_other.y());
  const auto gaps_at = [&](int e) {
    const DirectionLanes normal = turn * DirectionLanes{two_at(owner.nx + e), two_at(owner.ny + e)};
    TwoLanes deepest = normal.x * both(other.x[0]) + normal.y * both(other.y[0]);
    for (int v = 1; v < other.count; ++v) {
      deepest = smaller(deepest, normal.x * both(other.x[v]) + normal.y * both(other.y[v]));
    }
    return (deepest + (normal.x * to_x + normal.y * to_y)) - two_at(owner.offset + e);
  };
  TwoLanes edge = {0, 1};
  IndexedLanes largest = {gaps_at(0), edge};
  for (int e = 2; e < owner.count; e += 2) {
    edge += both(2);
    largest = larger(largest, {gaps_at(e), edge});
  }
  return largest;
}

/// Of two blocks: each one's largest gap, from those of its even and odd edges.
inline IndexedLanes largest_of_each(const IndexedLanes& a, const IndexedLanes& b) {
  return larger({firsts(a.value, b.value), firsts(a.index, b.index)},
                {seconds(a.value, b.value), seconds(a.index, b.index)});
}

/// Up to this many vertex-edge combinations they are all judged; beyond, the merge, whose every step waits
/// for the one before, is faster (tests/benchmarks, bench_pairs).
constexpr int most_combinations = 1024;

inline bool by_all_combinations(const Outline<2>& a, const Outline<2>& b) {
  return std::int64_t(a.count) * b.count <= most_combinations;
}

/// The largest of all gaps, or the first above 0, by the merge of sorted normals.
Separation find_separation_by_merge(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b);

/// The potential pair of an edge whose gap is known.
template <class Turn>
[[gnu::always_inline]] inline Separation separation_at(double gap, int owner, int edge, const Outline<2>& a,
                                                       const Outline<2>& b, const Turn& b_in_a) {
  // By tables instead of branches: who owns it is as good as random.
  const Outline<2>* const blocks[] = {&a, &b};
  const Vector<2> normal = blocks[owner]->normal(edge);
  const Vector<2> seen_from_other[] = {b_in_a.inverse() * normal, b_in_a * normal};
  const Vector<2> from_a_to_b[] = {normal, -seen_from_other[1]};
  return {gap, {owner, edge, deepest_vertex(*blocks[1 - owner], seen_from_other[owner])}, from_a_to_b[owner]};
}

/// Judges all potential contact pairs, and stops at the first block that has a violated one (eqs. 12-16).
/// Each block is in its own frame; `b_in_a` turns from that of b into that of a, `to_b` leads from the
/// centroid of a to that of b in the frame of a, and `to_b_in_b` in that of b. For blocks within
/// most_combinations.
template <class Turn>
[[gnu::always_inline]] inline Separation find_separation_by_all(const Outline<2>& a, const Outline<2>& b,
                                                                const Vector<2>& to_b,
                                                                const Vector<2>& to_b_in_b,
                                                                const Turn& b_in_a) {
  const IndexedLanes of_a = largest_gaps(a, b, b_in_a.inverse(), to_b_in_b);
  const IndexedLanes first = largest_of_each(of_a, of_a);
  if (first.value[0] > 0) return separation_at(first.value[0], 0, int(first.index[0]), a, b, b_in_a);
  const IndexedLanes of_b = largest_gaps(b, a, b_in_a, -to_b);
  const IndexedLanes each = largest_of_each(of_a, of_b);
  const IndexedLanes best = larger(each, {exchanged(each.value), exchanged(each.index)});
  return separation_at(best.value[0], each.value[1] > each.value[0], int(best.index[0]), a, b, b_in_a);
}

/// The same for outlines in one orientation and of any count.
inline Separation find_separation(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b) {
  return by_all_combinations(a, b) ? find_separation_by_all(a, b, to_b, to_b, NoTurn())
                                   : find_separation_by_merge(a, b, to_b);
}

}  // namespace halfspace
