#include "geometry/polyhedron/division.h"

#include <algorithm>
#include <cmath>

#include "geometry/polyhedron/volume_sums.h"
#include "simd/two_lanes.h"

namespace halfspace {

/// Grows all arrays geometrically. The last one has the size that all have, wherever memory ran out before.
void DividedPolyhedron::gain_room_for(std::size_t vertices) {
  const std::size_t room = std::max(vertices, 2 * outside_.size());
  const auto widen = [](auto& array, std::size_t size) {
    if (array.size() < size) array.resize(size);
  };
  widen(vertex_, room);
  widen(twin_, 4 * room);
  widen(face_, 4 * room);
  widen(inside_, room);
  widen(crossings_, room);
  widen(walked_, 4 * room);
  widen(outside_, room);
}

void DividedPolyhedron::reserve(std::size_t edges, std::size_t vertices) {
  make_room(vertices);
  grow(first_of_vertex_, edges);
  grow(half_of_edge_, 2 * edges);
}

void DividedPolyhedron::begin(const Outline<3>& block, const VertexDepths& sounding, Index new_face) {
  const Topology& t = *block.topology;
  make_room(std::size_t(2 * t.edge_count));
  grow(first_of_vertex_, std::size_t(t.vertex_count));
  grow(half_of_edge_, std::size_t(2 * t.edge_count));
  vertex_count_ = 0;
  inside_count_ = 0;
  outside_count_ = 0;
  for (std::int32_t v = 0; v < t.vertex_count; ++v) {
    first_of_vertex_[std::size_t(v)] = vertex_count_;
    add_block_vertex(block, v, sounding.depth(v));
  }
  join_block_vertices(block);
  cut_edges_of_inside();
  close_inside(new_face);
}

/// An inner vertex with d edges becomes d - 2 vertices in a row, connected by edges of length 0 with the last
/// face on their left. The first and the last have two edges of the block, the others one. An outer vertex is
/// only a place where edges end.
void DividedPolyhedron::add_block_vertex(const Outline<3>& block, std::int32_t v, double depth) {
  const Vertex vertex{block.x[v], block.y[v], block.z[v], depth};
  if (depth < 0) {
    vertex_[vertex_count_++] = vertex;
    return;
  }
  const Topology& t = *block.topology;
  const std::int32_t begin = t.first_of_vertex[v], degree = t.first_of_vertex[v + 1] - begin;
  const std::int32_t *const edge = t.vertex_edge + begin, *const face = t.vertex_face + begin;
  const auto put = [&](std::int32_t k, Index half) {
    half_of_edge_[std::size_t(2 * edge[k] + (t.edge_start[edge[k]] == v))] = half;
  };
  put(0, 4 * vertex_count_);
  for (std::int32_t k = 1; k < degree - 1; ++k) {
    const Index half = 4 * vertex_count_;
    put(k, half + 1);
    face_[half] = Index(face[k - 1]);
    face_[half + 1] = Index(face[k]);
    face_[half + 2] = Index(face[degree - 1]);
    if (k > 1) twin_[half] = half - 2;
    if (k < degree - 2) twin_[half + 2] = half + 4;
    vertex_[vertex_count_] = vertex;
    inside_[inside_count_++] = vertex_count_++;
  }
  put(degree - 1, 4 * (vertex_count_ - 1) + 2);
}

void DividedPolyhedron::join_block_vertices(const Outline<3>& block) {
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

void DividedPolyhedron::begin(const DividedPolyhedron& other) {
  vertex_count_ = other.vertex_count_;
  make_room(vertex_count_);
  std::copy_n(other.vertex_.begin(), vertex_count_, vertex_.begin());
  std::copy_n(other.twin_.begin(), 4 * vertex_count_, twin_.begin());
  std::copy_n(other.face_.begin(), 4 * vertex_count_, face_.begin());
}

DepthRange DividedPolyhedron::sound(Part part, const Halfspace<3>& plane) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const Index v : part) {
    Vertex& p = vertex_[v];
    p.depth = plane.offset - (plane.normal.x() * p.x + plane.normal.y() * p.y + plane.normal.z() * p.z);
    least = std::min(least, p.depth);
    most = std::max(most, p.depth);
  }
  return {least, most};
}

void DividedPolyhedron::cut_edges(Part part) {
  cut_edges(part, [vertex = vertex_.data()](Index v) { return vertex[v].depth; });
}

void DividedPolyhedron::cut_edges_of_inside() {
  // Up to two new vertices per edge, and room to write one crossing too many.
  make_room(vertex_count_ + 6 * inside_count_ + 1);
  Vertex* const vertex = vertex_.data();
  Index* const twin = twin_.data();
  Crossing* end = crossings_.data();
  for (const Index v : inside()) {
    for (Index k = 0; k < 3; ++k) {
      end->inner_half = 4 * v + k;
      end->outer_half = twin[4 * v + k];
      end += vertex[end->outer()].depth < 0;
    }
  }
  crossing_count_ = std::size_t(end - crossings_.data());
  Index added = vertex_count_;
  for (Crossing* crossing = crossings_.data(); crossing != end; ++crossing, ++added) {
    const Vertex &p = vertex[crossing->inner()], &q = vertex[crossing->outer()];
    crossing->share = p.depth / (p.depth - q.depth);
    // Interpolates the depth like a coordinate; it is computed again before it is used.
    const TwoLanes share = both(crossing->share), p_xy = load_two(&p.x), p_z = load_two(&p.z);
    store_two(&vertex[added].x, p_xy + share * (load_two(&q.x) - p_xy));
    store_two(&vertex[added].z, p_z + share * (load_two(&q.z) - p_z));
    twin[4 * added] = crossing->inner_half;
    twin[crossing->inner_half] = 4 * added;
  }
}

/// Sets the faces around a new vertex. One edge is the one cut, the others connect it along the new face.
inline void DividedPolyhedron::surround(Index vertex, Index left, Index right, Index new_face) {
  face_[4 * vertex] = right;
  face_[4 * vertex + 1] = new_face;
  face_[4 * vertex + 2] = left;
}

/// Connects the vertex where a face's outline leaves the part to the one where it returns.
inline void DividedPolyhedron::join(Index exit, Index entry) {
  twin_[4 * exit + 2] = 4 * entry + 1;
  twin_[4 * entry + 1] = 4 * exit + 2;
}

/// Calls `join(exit, entry)` for each cut face, several times where rounding has split the face.
template <class Join>
inline void DividedPolyhedron::join_along_faces(Join join) {
  Index entry = vertex_count_;
  for (const Crossing& crossing : crossings()) {
    Index half = clockwise(crossing.inner_half);
    while (twin_[half] < 4 * vertex_count_) half = clockwise(twin_[half]);
    join(twin_[half] / 4, entry++);
  }
}

void DividedPolyhedron::close_inside(Index new_face) {
  Index added = vertex_count_;
  for (const Crossing& crossing : crossings()) {
    const auto [left, right] = faces_along(crossing);
    surround(added, left, right, new_face);
    inside_[inside_count_++] = added++;
  }
  join_along_faces([this](Index exit, Index entry) { join(exit, entry); });
  vertex_count_ = added;
}

void DividedPolyhedron::close_both(Index new_face) {
  const Index count = Index(crossing_count_);
  Index added = vertex_count_;
  for (const Crossing& crossing : crossings()) {
    const auto [left, right] = faces_along(crossing);
    const Index other = added + count;
    vertex_[other] = vertex_[added];
    twin_[4 * other] = crossing.outer_half;
    twin_[crossing.outer_half] = 4 * other;
    surround(added, left, right, new_face);
    surround(other, right, left, new_face);
    inside_[inside_count_++] = added++;
    outside_[outside_count_++] = other;
  }
  join_along_faces([this, count](Index exit, Index entry) {
    join(exit, entry);
    join(entry + count, exit + count);
  });
  vertex_count_ += 2 * count;
}

/// Sums over tetrahedra from one vertex, the top, to triangles of the faces that do not contain it. A cut
/// face is divided from the vertex where its outline enters; with the top in the cutting plane, the missing
/// new edges have no volume. Where rounding has split a face, each of its loops counts separately.
template <class Sums>
inline void DividedPolyhedron::sum_up_inside(Index top_vertex, Sums& sums) {
  const Vertex* const vertex = vertex_.data();
  const Index *const twin = twin_.data(), *const face = face_.data();
  const auto point = [&](Index v) { return Coordinates<double>{vertex[v].x, vertex[v].y, vertex[v].z}; };
  const Coordinates<double> top = point(top_vertex);
  const auto seen_from_top = [&](Index v) { return point(v) - top; };
  const Index first_new = vertex_count_;
  std::size_t walked = 0;
  // Along the outline of a face from a corner, until it leaves or, for an uncut face, returns.
  const auto add_face = [&](Index corner, Index half, bool at_top, bool is_whole) {
    const Coordinates<double> p = seen_from_top(corner);
    Coordinates<double> q = seen_from_top(half / 4);
    for (;; half = clockwise(twin[half])) {
      walked_[half] = true;
      ++walked;
      const Index next = twin[half] / 4;
      if (is_whole && next == corner) return;
      if (!at_top) {
        const Coordinates<double> r = seen_from_top(next);
        sums.add(p, q, r);
        q = r;
      }
      if (!is_whole && next >= first_new) return;
    }
  };
  for (const Index v : inside()) std::fill_n(walked_.begin() + 4 * v, 4, false);
  if (crossing_count_ > 0) {
    const Index face_at_top = face[crossings_[0].inner_half];
    Index added = first_new;
    for (const Crossing& crossing : crossings()) {
      const Index half = clockwise(crossing.inner_half);
      add_face(added, half, (added == top_vertex) | (face[half] == face_at_top), false);
      ++added;
    }
  }
  if (walked < 3 * inside_count_) {
    for (const Index v : inside()) {
      for (Index half = 4 * v; half < 4 * v + 3; ++half)
        if (!walked_[half]) add_face(v, clockwise(twin[half]), v == top_vertex, true);
    }
  }
}

VolumeAndMoment DividedPolyhedron::measure_inside() {
  if (inside_count_ == 0) return {};
  const Index top = crossing_count_ > 0 ? vertex_count_ : inside_[0];
  VolumeSums<double> sums;
  sum_up_inside(top, sums);
  return with_origin_at(position(top), sums);
}

VolumeAndSpread DividedPolyhedron::measure(Part part) {
  if (part.empty()) return {};
  std::copy(part.begin(), part.end(), inside_.begin());
  inside_count_ = part.size();
  crossing_count_ = 0;
  SpreadSums<double> sums;
  sum_up_inside(part[0], sums);
  return with_origin_at(position(part[0]), sums);
}

}  // namespace halfspace
