#pragma once

#include <cmath>
#include <cstdint>

#include "geometry/outline.h"
#include "narrow_phase/contact.h"
#include "narrow_phase/plane/edge_gaps.h"
#include "narrow_phase/plane/placement.h"
#include "simd/two_lanes.h"

namespace halfspace {

/// The blocks of a potential pair by their role. By a table instead of a branch, as the owner of the edge is
/// unpredictable.
struct Owner {
  Owner(const Outline<2>& a, const Outline<2>& b, const PotentialPair<2>& pair)
      : blocks{&a, &b}, block(*blocks[pair.owner]), other(*blocks[1 - pair.owner]), sign(signs[pair.owner]) {}

  static constexpr double signs[] = {1, -1};

  const Outline<2>* blocks[2];
  const Outline<2>& block;
  const Outline<2>& other;
  double sign;  // of vectors from a to b, relative to the owner
};

inline double height_along(const Vector<2>& normal, const Outline<2>& block, int vertex) {
  return normal.x() * block.x[vertex] + normal.y() * block.y[vertex];
}

/// The deepest vertex along the outer normal of the other block's half-space, which is their potential
/// contact pair (Wang et al. 2021, eq. 9): both its neighbours are farther out. Two vertices at a time, with
/// selections instead of branches, as the vertex is unpredictable.
inline int deepest_vertex(const Outline<2>& block, const Vector<2>& normal) {
  const TwoLanes nx = both(normal.x()), ny = both(normal.y());
  const auto heights_at = [&](int v) { return nx * load_two(block.x + v) + ny * load_two(block.y + v); };
  TwoLanes vertex = {0, 1};
  IndexedLanes deepest = {heights_at(0), vertex};
  for (int v = 2; v < block.count; v += 2) {
    vertex += both(2);
    deepest = min(deepest, {heights_at(v), vertex});
  }
  return int(min(deepest, {exchanged(deepest.value), exchanged(deepest.index)}).index[0]);
}

/// The same for a block of many vertices, by a walk from a nearby vertex.
int walk_to_deepest_vertex(const Outline<2>& block, const Vector<2>& normal, int hint);

/// The same by the faster method; `hint` is the start of a walk.
inline int deepest_vertex(const Outline<2>& block, const Vector<2>& normal, int hint) {
  constexpr int few = 12;
  return block.count <= few ? deepest_vertex(block, normal) : walk_to_deepest_vertex(block, normal, hint);
}

/// Gap of an edge: distance of the other block's deepest vertex from the half-space, negative inside (eq.
/// 10). `to_other` is the vector from the owner's centroid to the other's.
inline double edge_gap(const Outline<2>& owner, int edge, const Outline<2>& other, int vertex,
                       const Vector<2>& to_other) {
  const Vector<2> normal = owner.normal(edge);
  return (normal.dot(other.vertex(vertex)) + normal.dot(to_other)) - owner.offset[edge];
}

/// Up to this many vertex-edge combinations all are tested; beyond, the merge is faster, whose steps depend
/// on each other (tests/benchmarks, bench_pairs).
constexpr int max_combinations = 1024;

inline bool by_all_combinations(const Outline<2>& a, const Outline<2>& b) {
  return std::int64_t(a.count) * b.count <= max_combinations;
}

/// The largest of all gaps, or the first above the margin, by the merge of sorted normals.
Separation<2> find_separation_by_merge(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                                       double margin = 0);

/// The larger of both blocks' gaps. Without a branch, as the owner is unpredictable.
inline Separation<2> larger_of_each(const IndexedLanes& each) {
  const int owner = each.value[1] > each.value[0];
  const int edges[] = {int(each.index[0]), int(each.index[1])};
  const double gap = each.value[1] > each.value[0] ? each.value[1] : each.value[0];
  return {gap, {owner, edges[owner], 0}};
}

/// Tests all potential contact pairs (eqs. 12-16), within max_combinations. Except for two triangles, stops
/// after the first block with a gap above the margin.
template <class Lanes>
[[gnu::always_inline]] inline Separation<2> find_separation_by_all(const Outline<2>& a, const Outline<2>& b,
                                                                   const Placement<Lanes>& at,
                                                                   double margin = 0) {
  if (a.count == 3 && b.count == 3) return larger_of_each(largest_gap_of_each(a, b, at));
  const Placement<Lanes> seen_from_a = {both(at.into_other, 0), both(at.to_other, 0)};
  const IndexedLanes of_a = largest_gap(a, b, seen_from_a);
  if (of_a.value[0] > margin) return {of_a.value[0], {0, int(of_a.index[0]), 0}};
  const Placement<Lanes> seen_from_b = {both(at.into_other, 1), both(at.to_other, 1)};
  const IndexedLanes of_b = largest_gap(b, a, seen_from_b);
  return larger_of_each({firsts(of_a.value, of_b.value), firsts(of_a.index, of_b.index)});
}

/// The same for outlines in one orientation and any number of vertices. The pair's vertex is the deepest one.
inline Separation<2> find_separation(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                                     double margin = 0) {
  if (!by_all_combinations(a, b)) return find_separation_by_merge(a, b, to_b, margin);
  Separation<2> found = find_separation_by_all(a, b, placement_unturned(to_b), margin);
  const Owner owner(a, b, found.pair);
  found.pair.vertex = deepest_vertex(owner.other, owner.block.normal(found.pair.edge));
  return found;
}

/// The potential pair of largest gap, also when several are violated.
inline Separation<2> find_largest_separation(const Outline<2>& a, const Outline<2>& b,
                                             const Vector<2>& to_b) {
  return find_separation(a, b, to_b, HUGE_VAL);
}

}  // namespace halfspace
