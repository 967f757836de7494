#include "detect/separation.h"

#include <algorithm>

#include "detect/potential_pairs.h"

namespace halfspace {
namespace {

using Two = Eigen::Array2d;

/// Up to this many vertex-edge combinations, two at a time without branches beat the merge, whose every step waits for the one
/// before (tests/benchmarks, bench_pairs).
constexpr int most_combinations = 1024;

double height_along(const Vector<2>& normal, const Outline<2>& block, int vertex) {
  return normal.x() * block.x[vertex] + normal.y() * block.y[vertex];
}

Two two_at(const double* p) { return Eigen::Map<const Two>(p); }

/// Gap of each edge of `owner`, and the index of the largest.
struct LargestGap {
  double gap;
  int edge;
};

LargestGap largest_gap(const Outline<2>& owner, const Outline<2>& other, const Vector<2>& to_other) {
  LargestGap best{-HUGE_VAL, 0};
  for (int e = 0; e < owner.count; e += 2) {
    const Two nx = two_at(owner.nx + e);
    const Two ny = two_at(owner.ny + e);
    Two deepest = nx * other.x[0] + ny * other.y[0];
    for (int v = 1; v < other.count; ++v) deepest = deepest.min(nx * other.x[v] + ny * other.y[v]);
    const Two gap = (deepest + (nx * to_other.x() + ny * to_other.y())) - two_at(owner.offset + e);
    // Selections, not branches: which edge wins is as good as random.
    const bool first = gap[0] > best.gap;
    best.edge = first ? e : best.edge;
    best.gap = first ? gap[0] : best.gap;
    const bool second = gap[1] > best.gap;
    best.edge = second ? e + 1 : best.edge;
    best.gap = second ? gap[1] : best.gap;
  }
  return best;
}

Separation find_by_all_combinations(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b) {
  const LargestGap of_a = largest_gap(a, b, to_b);
  const LargestGap of_b = of_a.gap > 0 ? LargestGap{-HUGE_VAL, 0} : largest_gap(b, a, -to_b);
  const bool a_owns = of_a.gap >= of_b.gap;
  const Outline<2>& owner = a_owns ? a : b;
  const Outline<2>& other = a_owns ? b : a;
  const LargestGap& best = a_owns ? of_a : of_b;
  return {best.gap, {a_owns ? 0 : 1, best.edge, deepest_vertex(other, owner.normal(best.edge))}};
}

Separation find_by_merge(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b) {
  Separation best{-HUGE_VAL, {}};
  for_each_potential_pair(a, b, [&](const PotentialPair& pair) {
    const double gap = pair.owner == 0 ? edge_gap(a, pair.edge, b, pair.vertex, to_b)
                                       : edge_gap(b, pair.edge, a, pair.vertex, -to_b);
    if (gap > best.gap) best = {gap, pair};
    return best.gap <= 0;
  });
  return best;
}

}  // namespace

int deepest_vertex(const Outline<2>& block, const Vector<2>& normal) {
  int deepest = 0;
  double least = height_along(normal, block, 0);
  for (int v = 1; v < block.count; ++v) {
    const double height = height_along(normal, block, v);
    deepest = height < least ? v : deepest;
    least = std::min(height, least);
  }
  return deepest;
}

int deepest_vertex(const Outline<2>& block, const Vector<2>& normal, int hint) {
  constexpr int few = 12;  // scanned faster than walked
  if (block.count <= few) return deepest_vertex(block, normal);
  // The heights along a convex outline have one minimum: walk downhill to it, one way or the other.
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
  // Below the centroid the way down is steep; above it, a hint on a blunt top may have found none.
  return least < 0 ? deepest : deepest_vertex(block, normal);
}

Separation find_separation(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b) {
  return a.count * b.count <= most_combinations ? find_by_all_combinations(a, b, to_b) : find_by_merge(a, b, to_b);
}

}  // namespace halfspace
