#pragma once

#include <array>

#include "geometry/outline.h"
#include "narrow_phase/plane/placement.h"
#include "simd/indexed_lanes.h"
#include "simd/two_lanes.h"

namespace halfspace {

// These functions are inlined by force: called, they would hand their lanes over through memory, in the chain
// of operations that the first branch on a pair waits for.

/// Heights of points along directions.
inline TwoLanes heights_along(const DirectionLanes& directions, const DirectionLanes& points) {
  return directions.x * points.x + directions.y * points.y;
}

/// Half-spaces of two edges, side by side.
struct HalfspaceLanes {
  DirectionLanes normal;
  TwoLanes offset;
};

/// Two edges of one block, which meet the same vertices of the other.
struct EdgesOfOne {
  const Outline<2>& owner;
  const Outline<2>& other;

  [[gnu::always_inline]] HalfspaceLanes edges(int e) const {
    return {{load_two(owner.nx + e), load_two(owner.ny + e)}, load_two(owner.offset + e)};
  }
  [[gnu::always_inline]] DirectionLanes vertices(int v) const { return {both(other.x[v]), both(other.y[v])}; }
  [[gnu::always_inline]] int vertex_count() const { return other.count; }
};

/// An edge of each of two triangles, which meet one another's vertices.
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
  // From the first array all others are found without a look at the outline.
  static constexpr int stride = Outline<2>::padded(3);
  enum Component { x = 0, y = stride, nx = 2 * stride, ny = 3 * stride, offset = 4 * stride };
  [[gnu::always_inline]] static TwoLanes each(const double* first, const double* second, Component c, int i) {
    return TwoLanes{first[c + i], second[c + i]};
  }

  const double* a_;
  const double* b_;
};

/// Gaps of edges, by all combinations with the other's vertices, of which there are three at least: those of
/// the edges e, two side by side, and of as many pairs that follow. They share what is read of the vertices.
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

/// The larger of each lane of two pairs of edges that follow one another.
inline IndexedLanes larger_of_two(const std::array<TwoLanes, 2>& gaps, TwoLanes first_edges) {
  return max(IndexedLanes{gaps[0], first_edges}, IndexedLanes{gaps[1], first_edges + both(2)});
}

/// The largest gap among the edges of `owner`. Of the other's arrays only the vertices are read.
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

/// The largest gap of each of two triangles, both side by side: no lane is lost on padding, and there is no
/// branch between them.
template <class Lanes>
[[gnu::always_inline]] inline IndexedLanes largest_gap_of_each(const Outline<2>& a, const Outline<2>& b,
                                                               const Placement<Lanes>& at) {
  const EdgesOfTriangles blocks{a, b};
  const auto gaps_of = [&](int e) { return IndexedLanes{gaps_at<1>(e, blocks, at)[0], both(e)}; };
  return max(max(gaps_of(0), gaps_of(1)), gaps_of(2));
}

}  // namespace halfspace
