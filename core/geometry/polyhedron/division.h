#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/outline.h"
#include "geometry/polyhedron/sounding.h"
#include "geometry/polyhedron/volume_sums.h"

namespace halfspace {

/// Not inlined, so that the usual test for capacity needs no call.
template <class T>
[[gnu::noinline]] void gain_room(Array<T>& array, std::size_t room) {
  array.resize(std::max(room, 2 * array.size()));
}

/// Grows an array geometrically to at least `room` entries; never shrinks, so that reuse allocates nothing.
template <class T>
void grow(Array<T>& array, std::size_t room) {
  if (array.size() < room) gain_room(array, room);
}

/// A convex polyhedron divided by planes in place. Where an edge crosses the plane, each part gets a new
/// vertex, and these are connected to a new face. A part is identified by its vertices. Its edges may have
/// length 0 and its faces no area, but its surface is closed, wherever rounding places the vertices.
///
/// Three edges meet at each vertex; a block's vertex with more edges becomes several vertices in one place.
///
/// The caller numbers the faces: the numbers of the faces at a vertex identify its origin.
class DividedPolyhedron {
 public:
  using Index = std::uint32_t;
  using Part = std::span<const Index>;

  /// The crossing of the plane with an edge from an inner to an outer vertex; `share` is the inner fraction.
  struct Crossing {
    Index inner_half;  // half-edges from both vertices
    Index outer_half;
    double share;
    Index inner() const { return inner_half / 4; }
    Index outer() const { return outer_half / 4; }
  };

  explicit DividedPolyhedron(Memory* memory)
      : vertex_(memory),
        twin_(memory),
        face_(memory),
        inside_(memory),
        outside_(memory),
        crossings_(memory),
        walked_(memory),
        first_of_vertex_(memory),
        half_of_edge_(memory) {}

  /// Reserves memory for blocks of up to `edges` edges and divisions of up to `vertices` vertices.
  void reserve(std::size_t edges, std::size_t vertices);

  /// Starts with the part of a block behind a plane, given its vertices' depths. The block's faces keep their
  /// indices.
  void begin(const Outline<3>& block, const VertexDepths& sounding, Index new_face);
  void begin(const DividedPolyhedron& other);

  /// The number of vertices of all parts, including discarded ones.
  Index vertex_count() const { return vertex_count_; }
  /// Discards the vertices from this number on.
  void shrink_to(Index vertices) { vertex_count_ = vertices; }

  Vector<3> position(Index vertex) const {
    const Vertex& v = vertex_[vertex];
    return {v.x, v.y, v.z};
  }
  std::array<Index, 3> faces_at(Index vertex) const {
    return {face_[4 * vertex], face_[4 * vertex + 1], face_[4 * vertex + 2]};
  }
  /// The faces on both sides of the edge.
  std::array<Index, 2> faces_along(const Crossing& crossing) const {
    return {face_[crossing.inner_half], face_[clockwise(crossing.inner_half)]};
  }

  /// Computes the depths of a part's vertices behind a plane, before a cut.
  DepthRange sound(Part part, const Halfspace<3>& plane);

  /// Measures an uncut part, or the inside of a cut before it is closed.
  VolumeAndSpread measure(Part part);
  VolumeAndMoment measure_inside();

  /// Cuts the edges of a part at the depths of its vertices computed before. Vertices in the plane are
  /// inside.
  void cut_edges(Part part);
  /// The same at the depths depth_of(vertex).
  template <class DepthOf>
  void cut_edges(Part part, DepthOf depth_of);
  /// Closes the inside, or both parts, by a new face. The new vertices are the last of each part, in the
  /// order of the crossings.
  void close_inside(Index new_face);
  void close_both(Index new_face);
  /// Undoes the cut of the part's edges.
  void take_back_cut() {
    for (const Crossing& crossing : crossings()) twin_[crossing.inner_half] = crossing.outer_half;
  }
  Part inside() const { return {inside_.data(), inside_count_}; }
  Part outside() const { return {outside_.data(), outside_count_}; }
  std::span<const Crossing> crossings() const { return {crossings_.data(), crossing_count_}; }

 private:
  struct Vertex {
    double x, y, z;
    double depth;  // behind the cutting plane
  };

  // Half-edges 4 v, 4 v + 1 and 4 v + 2 leave vertex v, counter-clockwise seen from outside.
  static Index clockwise(Index half) { return (half & 3) == 0 ? half + 2 : half - 1; }

  void make_room(std::size_t vertices) {
    if (outside_.size() < vertices) gain_room_for(vertices);
  }
  void gain_room_for(std::size_t vertices);
  void add_block_vertex(const Outline<3>& block, std::int32_t v, double depth);
  void join_block_vertices(const Outline<3>& block);
  void cut_edges_of_inside();
  void surround(Index vertex, Index left, Index right, Index new_face);
  void join(Index exit, Index entry);
  template <class Join>
  void join_along_faces(Join join);
  template <class Sums>
  void sum_up_inside(Index top, Sums& sums);

  Array<Vertex> vertex_;
  Array<Index> twin_;  // the opposite half-edge
  Array<Index> face_;  // on the left of the half-edge
  Array<Index> inside_;
  Array<Index> outside_;
  Array<Crossing> crossings_;
  Array<std::uint8_t> walked_;    // half-edges measured already
  Array<Index> first_of_vertex_;  // index of the first vertex of each of the block's
  Array<Index> half_of_edge_;     // half-edges of each of the block's edges, from its end and from its start
  Index vertex_count_ = 0;
  std::size_t inside_count_ = 0;
  std::size_t outside_count_ = 0;
  std::size_t crossing_count_ = 0;
};

/// Without branches: the side of a vertex is unpredictable.
template <class DepthOf>
void DividedPolyhedron::cut_edges(Part part, DepthOf depth_of) {
  Vertex* const vertex = vertex_.data();
  Index *in = inside_.data(), *out = outside_.data();
  for (const Index v : part) {
    const double depth = depth_of(v);
    vertex[v].depth = depth;
    const bool is_inside = !(depth < 0);
    *in = *out = v;
    in += is_inside;
    out += !is_inside;
  }
  inside_count_ = std::size_t(in - inside_.data());
  outside_count_ = std::size_t(out - outside_.data());
  cut_edges_of_inside();
}

}  // namespace halfspace
