#pragma once

#include <array>

#include "geometry/outline.h"
#include "narrow_phase/plane/placement.h"
#include "simd/indexed_lanes.h"
#include "simd/two_lanes.h"

namespace halfspace {

// These functions are always inlined: calls would pass lanes through memory, on the critical path to the
// first branch on a pair.

/// Heights of points along directions.
inline TwoLanes heights_along(const DirectionLanes& directions, const DirectionLanes& points) {
  return directions.x * points.x + directions.y * points.y;
}

/// Half-spaces of two edges, one per lane.
struct HalfspaceLanes {
  DirectionLanes normal;
  TwoLanes offset;
};

/// Two edges of one block, tested with the same vertices of the other.
struct EdgesOfOne {
  const Outline<2>& owner;
  const Outline<2>& other;

  [[gnu::always_inline]] HalfspaceLanes edges(int e) const {
    return {{load_two(owner.nx + e), load_two(owner.ny + e)}, load_two(owner.offset + e)};
  }
  [[gnu::always_inline]] DirectionLanes vertices(int v) const { return {both(other.x[v]), both(other.y[v])}; }
  [[gnu::always_inline]] int vertex_count() const { return other.count; }
};

/// One edge of each of two triangles, tested with the vertices of the other.
class EdgesOfTriangles {
 public:
  [[gnu::always_inline]] EdgesOfTriangles(const Outline<2>& a, const Outline<2>& b) : a_(a.x), b_(b.x) {}

  [[gnu::always_inline]] HalfspaceLanes edges(int e) const {
    return {{each(a_, b_, nx, e), each(a_, b_, ny, e)}, each(a_, b_, offset, e)};
  }
  [[gnu::always_inline]] DirectionLanes vertices(int v) const {
    return {each(b_, a_, x, v), each(b_, a_, y, v)};
  }
  [[gnu::always_inline]] int vertex_count() const { return 3; }

 private:
  // All arrays are at fixed offsets from the first one, so that the outline is not read.
  static constexpr int stride = Outline<2>::padded(3);
  enum Component { x = 0, y = stride, nx = 2 * stride, ny = 3 * stride, offset = 4 * stride };
  [[gnu::always_inline]] static TwoLanes each(const double* first, const double* second, Component c, int i) {
    return TwoLanes{first[c + i], second[c + i]};
  }

  const double* a_;
  const double* b_;
};

/// Gaps of edges over all vertices of the other block, at least three: of edges e and e + 1, one per lane,
/// and of the following pairs. The vertices are loaded once for all of them.
template <int pairs, class Blocks, class Lanes>
[[gnu::always_inline]] inline std::array<TwoLanes, pairs> gaps_at(int e, const Blocks& blocks,
                                                                  const Placement<Lanes>& at) {
  std::array<DirectionLanes, pairs> normal;
  std::array<TwoLanes, pairs> gap;
  for (int k = 0; k < pairs; ++k) {
    normal[k] = turned(at.into_other, blocks.edges(e + 2 * k).normal);
    gap[k] = heights_along(normal[k], blocks.vertices(0));
    gap[k] = min(gap[k], heights_along(normal[k], blocks.vertices(1)));
    gap[k] = min(gap[k], heights_along(normal[k], blocks.vertices(2)));
  }
  for (int v = 3; v < blocks.vertex_count(); ++v) {
    for (int k = 0; k < pairs; ++k) gap[k] = min(gap[k], heights_along(normal[k], blocks.vertices(v)));
  }
  for (int k = 0; k < pairs; ++k) {
    const HalfspaceLanes edges = blocks.edges(e + 2 * k);
    gap[k] = (gap[k] + heights_along(edges.normal, at.to_other)) - edges.offset;
  }
  return gap;
}

/// The larger gap of two successive pairs of edges, per lane.
inline IndexedLanes larger_of_two(const std::array<TwoLanes, 2>& gaps, TwoLanes first_edges) {
  return max(IndexedLanes{gaps[0], first_edges}, IndexedLanes{gaps[1], first_edges + both(2)});
}

/// The largest gap among the edges of `owner`. Of the other block only vertices are read.
template <class Lanes>
[[gnu::always_inline]] inline IndexedLanes largest_gap(const Outline<2>& owner, const Outline<2>& other,
                                                       const Placement<Lanes>& at) {
  const EdgesOfOne blocks{owner, other};
  TwoLanes edge = {0, 1};
  IndexedLanes largest = larger_of_two(gaps_at<2>(0, blocks, at), edge);
  int e = 4;
  for (; e + 2 < owner.count; e += 4) {
    edge += both(4);
    largest = max(largest, larger_of_two(gaps_at<2>(e, blocks, at), edge));
  }
  if (e < owner.count) largest = max(largest, IndexedLanes{gaps_at<1>(e, blocks, at)[0], edge + both(4)});
  return max(largest, IndexedLanes{exchanged(largest.value), exchanged(largest.index)});
}

/// The largest gap of each of two triangles, one per lane: without padding lanes, and without a branch
/// between them.
template <class Lanes>
[[gnu::always_inline]] inline IndexedLanes largest_gap_of_each(const Outline<2>& a, const Outline<2>& b,
                                                               const Placement<Lanes>& at) {
  const EdgesOfTriangles blocks{a, b};
  const auto gaps_of = [&](int e) { return IndexedLanes{gaps_at<1>(e, blocks, at)[0], both(e)}; };
  return max(max(gaps_of(0), gaps_of(1)), gaps_of(2));
}

}  // namespace halfspace
