#include "geometry/polyhedron/clipped.h"

#include <algorithm>
#include <cmath>

#include "geometry/polyhedron/volume_sums.h"
#include "simd/two_lanes.h"

namespace halfspace {

/// Not inlined, so that the usual test for room needs no call. The last array has the size that all have,
/// wherever memory ran out before.
[[gnu::noinline]] void ClippedPolyhedron::gain_room_for(std::size_t vertices) {
  const std::size_t room = std::max(vertices, walked_.size() / 2);
  grow(vertex_, room);
  grow(twin_, 4 * room);
  grow(inside_, room);
  grow(crossing_, room);
  grow(walked_, 4 * room);
}

void ClippedPolyhedron::reserve(std::size_t edges, std::size_t vertices) {
  make_room(vertices);
  grow(first_of_vertex_, edges);
  grow(half_of_edge_, 2 * edges);
}

void ClippedPolyhedron::begin(const Outline<3>& block, const VertexDepths& sounding) {
  const Topology& t = *block.topology;
  make_room(std::size_t(2 * t.edge_count));
  grow(first_of_vertex_, std::size_t(t.vertex_count));
  grow(half_of_edge_, std::size_t(2 * t.edge_count));
  vertex_count_ = 0;
  inside_count_ = 0;
  for (std::int32_t v = 0; v < t.vertex_count; ++v) {
    first_of_vertex_[std::size_t(v)] = vertex_count_;
    add_block_vertex(block, v, sounding.depth(v));
  }
  join_block_vertices(block);
  clip();
}

/// An inner vertex with d edges becomes d - 2 vertices in a row, connected by edges of length 0. The first
/// and the last have two edges of the block, the others one. An outer vertex is only a place where edges end.
void ClippedPolyhedron::add_block_vertex(const Outline<3>& block, std::int32_t v, double depth) {
  const Vertex vertex{block.x[v], block.y[v], block.z[v], depth};
  if (depth < 0) {
    vertex_[vertex_count_++] = vertex;
    return;
  }
  const Topology& t = *block.topology;
  const std::int32_t begin = t.first_of_vertex[v], degree = t.first_of_vertex[v + 1] - begin;
  const std::int32_t* const edge = t.vertex_edge + begin;
  const auto put = [&](std::int32_t k, Index half) {
    half_of_edge_[std::size_t(2 * edge[k] + (t.edge_start[edge[k]] == v))] = half;
  };
  put(0, 4 * vertex_count_);
  for (std::int32_t k = 1; k < degree - 1; ++k) {
    const Index half = 4 * vertex_count_;
    put(k, half + 1);
    if (k > 1) twin_[half] = half - 2;
    if (k < degree - 2) twin_[half + 2] = half + 4;
    vertex_[vertex_count_] = vertex;
    inside_[inside_count_++] = vertex_count_++;
  }
  put(degree - 1, 4 * (vertex_count_ - 1) + 2);
}

void ClippedPolyhedron::join_block_vertices(const Outline<3>& block) {
  const Topology& t = *block.topology;
  for (std::int32_t v = 0; v < t.vertex_count; ++v) {
    if (vertex_[first_of_vertex_[std::size_t(v)]].depth < 0) continue;
    for (std::int32_t k = t.first_of_vertex[v]; k < t.first_of_vertex[v + 1]; ++k) {
      const std::int32_t edge = t.vertex_edge[k], at_start = t.edge_start[edge] == v;
      const Index other = first_of_vertex_[std::size_t(t.vertex_neighbour[k])];
      twin_[half_of_edge_[std::size_t(2 * edge + at_start)]] =
          vertex_[other].depth < 0 ? 4 * other : half_of_edge_[std::size_t(2 * edge + 1 - at_start)];
    }
  }
}

void ClippedPolyhedron::begin(const ClippedPolyhedron& other) {
  vertex_count_ = other.vertex_count_;
  inside_count_ = other.inside_count_;
  make_room(vertex_count_);
  std::copy_n(other.vertex_.begin(), vertex_count_, vertex_.begin());
  std::copy_n(other.twin_.begin(), 4 * vertex_count_, twin_.begin());
  std::copy_n(other.inside_.begin(), inside_count_, inside_.begin());
}

DepthRange ClippedPolyhedron::sound(const Halfspace<3>& plane) {
  const TwoLanes nx = both(plane.normal.x()), ny = both(plane.normal.y()), nz = both(plane.normal.z()),
                 offset = both(plane.offset);
  TwoLanes least = both(HUGE_VAL), most = both(-HUGE_VAL);
  Vertex* const vertex = vertex_.data();
  const Index* const inside = inside_.data();
  for (std::size_t i = 0; i < inside_count_; i += 2) {
    Vertex &p = vertex[inside[i]], &q = vertex[inside[std::min(i + 1, inside_count_ - 1)]];
    const TwoLanes depth =
        offset - (nx * TwoLanes{p.x, q.x} + ny * TwoLanes{p.y, q.y} + nz * TwoLanes{p.z, q.z});
    p.depth = depth[0];
    q.depth = depth[1];
    least = min(least, depth);
    most = max(most, depth);
  }
  return {std::min(least[0], least[1]), std::max(most[0], most[1])};
}

/// Without branches: the side of a vertex is unpredictable.
void ClippedPolyhedron::cut() {
  Index* end = inside_.data();
  for (const Index v : vertices()) {
    *end = v;
    end += !(vertex_[v].depth < 0);
  }
  inside_count_ = std::size_t(end - inside_.data());
  clip();
}

/// Ends the edges that leave inside at new vertices, then connects the one where a face's outline leaves to
/// the one where it returns. Where rounding has split a face, it has several such outlines.
void ClippedPolyhedron::clip() {
  // Each half-edge may cross, and there is room to write one crossing too many.
  make_room(vertex_count_ + 3 * inside_count_ + 1);
  Index* const twin = twin_.data();
  Index* end = crossing_.data();
  for (const Index v : vertices()) {
    for (Index half = 4 * v; half < 4 * v + 3; ++half) {
      *end = half;
      end += vertex_[twin[half] / 4].depth < 0;
    }
  }
  const Index first_new = vertex_count_;
  for (Index* crossing = crossing_.data(); crossing != end; ++crossing)
    place_crossing(vertex_count_++, *crossing);
  for (Index entry = first_new; entry < vertex_count_; ++entry) {
    Index half = clockwise(crossing_[entry - first_new]);
    while (twin[half] < 4 * first_new) half = clockwise(twin[half]);
    const Index exit = twin[half] / 4;
    twin[4 * exit + 2] = 4 * entry + 1;
    twin[4 * entry + 1] = 4 * exit + 2;
    inside_[inside_count_++] = entry;
  }
}

/// Places a new vertex where an edge crosses the plane.
inline void ClippedPolyhedron::place_crossing(Index added, Index inner_half) {
  const Vertex &p = vertex_[inner_half / 4], &q = vertex_[twin_[inner_half] / 4];
  // Interpolates the depth like a coordinate; it is computed again before it is used.
  const TwoLanes share = both(p.depth / (p.depth - q.depth)), p_xy = load_two(&p.x), p_z = load_two(&p.z);
  store_two(&vertex_[added].x, p_xy + share * (load_two(&q.x) - p_xy));
  store_two(&vertex_[added].z, p_z + share * (load_two(&q.z) - p_z));
  twin_[4 * added] = inner_half;
  twin_[inner_half] = 4 * added;
}

/// Sums over tetrahedra from one vertex, the top, to triangles of the faces that do not contain it. A face is
/// divided from its first corner in the order of vertices. Where rounding has split a face, each of its loops
/// counts separately.
template <class Sums>
Sums ClippedPolyhedron::sum_up() {
  const Vertex* const vertex = vertex_.data();
  const Index* const twin = twin_.data();
  const auto point = [&](Index v) { return Vector<3>(vertex[v].x, vertex[v].y, vertex[v].z); };
  const Index top_vertex = inside_[0];
  const Vector<3> top = point(top_vertex);
  for (const Index v : vertices()) std::fill_n(walked_.begin() + 4 * v, 4, false);
  Sums sums;
  for (const Index corner : vertices()) {
    const Vector<3> p = point(corner) - top;
    for (Index first = 4 * corner; first < 4 * corner + 3; ++first) {
      if (walked_[first]) continue;
      Index half = clockwise(twin[first]);
      walked_[half] = true;
      Vector<3> q = point(half / 4) - top;
      for (Index next = twin[half] / 4; next != corner; next = twin[half] / 4) {
        half = clockwise(twin[half]);
        walked_[half] = true;
        if (corner == top_vertex) continue;
        const Vector<3> r = point(next) - top;
        sums.add(p, q, r);
        q = r;
      }
    }
  }
  return sums;
}

VolumeAndMoment ClippedPolyhedron::measure() {
  if (inside_count_ == 0) return {};
  return sum_up<VolumeSums>().with_origin_at(position(inside_[0]));
}

VolumeAndSpread ClippedPolyhedron::measure_with_spread() {
  if (inside_count_ == 0) return {};
  return sum_up<SpreadSums>().with_origin_at(position(inside_[0]));
}

}  // namespace halfspace
