#pragma once

#include <cmath>

#include "detect/contact.h"
#include "geometry/outline.h"

namespace halfspace {

/// A violated potential pair, or the pair of least depth when none is violated, and its gap.
struct Separation {
  double gap;
  PotentialPair pair;
};

/// The largest gap of a block's edges, and its edge.
struct LargestGap {
  double gap;
  int edge;
};

inline double height_along(const Vector<2>& normal, const Outline<2>& block, int vertex) {
  return normal.x() * block.x[vertex] + normal.y() * block.y[vertex];
}

/// The vertex that lies deepest along the outer normal of the other block's half-space, that is the vertex which forms a
/// potential contact pair with it (Wang et al. 2021, eq. 9): both its neighbours lie farther out.
inline int deepest_vertex(const Outline<2>& block, const Vector<2>& normal) {
  int deepest = 0;
  double least = height_along(normal, block, 0);
  for (int v = 1; v < block.count; ++v) {
    const double height = height_along(normal, block, v);
    deepest = height < least ? v : deepest;
    least = height < least ? height : least;
  }
  return deepest;
}

/// The same for a block of many vertices, by a walk from a vertex near it.
int walk_to_deepest_vertex(const Outline<2>& block, const Vector<2>& normal, int hint);

/// The same, by whichever is faster; `hint` is where to look first.
inline int deepest_vertex(const Outline<2>& block, const Vector<2>& normal, int hint) {
  constexpr int few = 12;
  return block.count <= few ? deepest_vertex(block, normal) : walk_to_deepest_vertex(block, normal, hint);
}

/// Gap of an edge: distance of the other block's deepest vertex from the half-space, below 0 when it is inside (eq. 10).
/// `to_other` leads from the owner's centroid to the other's.
inline double edge_gap(const Outline<2>& owner, int edge, const Outline<2>& other, int vertex, const Vector<2>& to_other) {
  const Vector<2> normal = owner.normal(edge);
  return (normal.dot(other.vertex(vertex)) + normal.dot(to_other)) - owner.offset[edge];
}

/// The largest gap of any edge of `owner`, by all combinations of its edges with the other's vertices. Of the other's arrays only
/// the vertices are read. Two edges at a time, and selections instead of branches: which edge wins is as good as random.
inline LargestGap largest_gap(const Outline<2>& owner, const Outline<2>& other, const Vector<2>& to_other) {
  using Two = Eigen::Array2d;
  const auto two_at = [](const double* p) { return Two(Eigen::Map<const Two>(p)); };
  Two best = Two::Constant(-HUGE_VAL);
  Two best_edge = Two::Zero();
  Two edge(0, 1);
  for (int e = 0; e < owner.count; e += 2) {
    const Two nx = two_at(owner.nx + e);
    const Two ny = two_at(owner.ny + e);
    Two deepest = nx * other.x[0] + ny * other.y[0];
    for (int v = 1; v < other.count; ++v) deepest = deepest.min(nx * other.x[v] + ny * other.y[v]);
    const Two gap = (deepest + (nx * to_other.x() + ny * to_other.y())) - two_at(owner.offset + e);
    best_edge = (gap > best).select(edge, best_edge);
    best = best.max(gap);
    edge += 2;
  }
  const bool second = best[1] > best[0];
  return {second ? best[1] : best[0], int(second ? best_edge[1] : best_edge[0])};
}

/// Up to this many vertex-edge combinations they are all judged; beyond, the merge, whose every step waits for the one before, is
/// faster (tests/benchmarks, bench_pairs).
constexpr int most_combinations = 1024;

inline bool by_all_combinations(const Outline<2>& a, const Outline<2>& b) { return a.count * b.count <= most_combinations; }

/// The potential pair of a block's edge with the largest gap.
inline Separation pair_of(const LargestGap& gap, int owner, const Outline<2>& with_edge, const Outline<2>& with_vertex) {
  return {gap.gap, {owner, gap.edge, deepest_vertex(with_vertex, with_edge.normal(gap.edge))}};
}

/// The largest of all gaps, or the first above 0, by the merge of sorted normals.
Separation find_separation_by_merge(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b);

/// Judges all potential contact pairs, and stops at the first block that has a violated one (eqs. 12-16).
/// `to_b` leads from the centroid of a to that of b; both outlines are in the same orientation. `turn_normals` is called before
/// the normals of b are read: often they never are.
template <class TurnNormals>
Separation find_separation(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, TurnNormals turn_normals) {
  if (!by_all_combinations(a, b)) {
    turn_normals();
    return find_separation_by_merge(a, b, to_b);
  }
  const LargestGap of_a = largest_gap(a, b, to_b);
  if (of_a.gap > 0) return pair_of(of_a, 0, a, b);
  turn_normals();
  const LargestGap of_b = largest_gap(b, a, -to_b);
  return of_a.gap >= of_b.gap ? pair_of(of_a, 0, a, b) : pair_of(of_b, 1, b, a);
}

}  // namespace halfspace
