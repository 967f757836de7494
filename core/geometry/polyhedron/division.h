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

/// Apart, so that looking whether there is room costs no call.
template <class T>
[[gnu::noinline]] void gain_room(Array<T>& array, std::size_t room) {
  array.resize(std::max(room, 2 * array.size()));
}

/// So many entries at least, gained by doubling: room that is filled anew asks for no memory that it had
/// before.
template <class T>
void grow(Array<T>& array, std::size_t room) {
  if (array.size() < room) gain_room(array, room);
}

/// A convex polyhedron that planes cut into parts where it lies: where an edge crosses the plane either part
/// gets a vertex of its own, and these are joined to a new face. Nothing else is touched. A part is known by
/// its vertices. Its edges may have no length and its faces no area, but its surface is closed, however
/// rounding places the vertices.
///
/// Three edges meet at each vertex; where a block has more, there are several vertices in one place.
///
/// A face has the number that it is told to have: those that meet at a vertex tell where it comes from.
class DividedPolyhedron {
 public:
  using Index = std::uint32_t;
  using Part = std::span<const Index>;

  /// Where an edge from a vertex inside to one outside crosses the plane: so much of it is inside.
  struct Crossing {
    Index inner_half;  // of the edge, seen from either vertex
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

  /// For blocks of so many edges at most, until there are more than so many vertices.
  void reserve(std::size_t edges, std::size_t vertices);

  /// Begins with what of a block is inside a plane, behind which it has been sounded. The block's faces keep
  /// their numbers.
  void begin(const Outline<3>& block, const VertexDepths& sounding, Index new_face);
  void begin(const DividedPolyhedron& other);

  /// The number of all parts, those that are wanted no more included.
  Index vertex_count() const { return vertex_count_; }
  /// Takes back what has been added since there were so many vertices.
  void shrink_to(Index vertices) { vertex_count_ = vertices; }

  Vector<3> position(Index vertex) const {
    const Vertex& v = vertex_[vertex];
    return {v.x, v.y, v.z};
  }
  std::array<Index, 3> faces_at(Index vertex) const {
    return {face_[4 * vertex], face_[4 * vertex + 1], face_[4 * vertex + 2]};
  }
  /// On either side of the edge.
  std::array<Index, 2> faces_along(const Crossing& crossing) const {
    return {face_[crossing.inner_half], face_[clockwise(crossing.inner_half)]};
  }

  /// How deep the vertices of a part lie behind a plane: what is known before it is cut there.
  DepthRange sound(Part part, const Halfspace<3>& plane);

  /// Measures a part that has not been cut, or what is inside the plane where one has just been cut.
  VolumeAndSpread measure(Part part);
  VolumeAndMoment measure_inside();

  /// Cuts the edges of a part behind whose plane its vertices have been sounded. Vertices in the plane are
  /// inside.
  void cut_edges(Part part);
  /// By what `depth_of(vertex)` tells.
  template <class DepthOf>
  void cut_edges(Part part, DepthOf depth_of);
  /// Closes what is inside, or both parts, by a new face. The new vertices are the last ones of either part,
  /// in the order of the crossings.
  void close_inside(Index new_face);
  void close_both(Index new_face);
  /// As if the part had not been cut.
  void take_back_cut() {
    for (const Crossing& crossing : crossings()) twin_[crossing.inner_half] = crossing.outer_half;
  }
  Part inside() const { return {inside_.data(), inside_count_}; }
  Part outside() const { return {outside_.data(), outside_count_}; }
  std::span<const Crossing> crossings() const { return {crossings_.data(), crossing_count_}; }

 private:
  struct Vertex {
    double x, y, z;
    double depth;  // behind the plane to cut at
  };

  // Halves 4 v, 4 v + 1 and 4 v + 2 of edges leave vertex v, counter-clockwise seen from outside.
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
  Array<Index> twin_;  // of half an edge, seen from its other vertex
  Array<Index> face_;  // on its left
  Array<Index> inside_;
  Array<Index> outside_;
  Array<Crossing> crossings_;
  Array<std::uint8_t> walked_;    // which halves of edges have been measured
  Array<Index> first_of_vertex_;  // of the block's
  Array<Index> half_of_edge_;     // of the block's, seen from its end and from its start
  Index vertex_count_ = 0;
  std::size_t inside_count_ = 0;
  std::size_t outside_count_ = 0;
  std::size_t crossing_count_ = 0;
};

/// Without branches: on which side a vertex is, is as good as random.
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
