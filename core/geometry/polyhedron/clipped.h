#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/outline.h"
#include "geometry/polyhedron/sounding.h"
#include "geometry/polyhedron/volume_sums.h"

namespace halfspace {

/// Grows an array geometrically to at least `room` entries; never shrinks, so that reuse allocates nothing.
template <class T>
void grow(Array<T>& array, std::size_t room) {
  if (array.size() < room) array.resize(std::max(room, 2 * array.size()));
}

/// A convex polyhedron that planes cut in place. Where an edge crosses the plane, it ends at a new vertex,
/// and the new vertices are connected around a new face. Edges may have length 0 and faces no area, but the
/// surface is closed, wherever rounding places the vertices.
///
/// Three edges meet at each vertex; a block's vertex with more edges becomes several vertices in one place.
class ClippedPolyhedron {
 public:
  using Index = std::uint32_t;

  explicit ClippedPolyhedron(Memory* memory)
      : vertex_(memory),
        twin_(memory),
        inside_(memory),
        crossing_(memory),
        walked_(memory),
        first_of_vertex_(memory),
        half_of_edge_(memory) {}

  /// Reserves memory for blocks of up to `edges` edges and cuts with up to `vertices` vertices.
  void reserve(std::size_t edges, std::size_t vertices);

  /// Starts with the part of a block behind a plane, given its vertices' depths.
  void begin(const Outline<3>& block, const VertexDepths& sounding);
  void begin(const ClippedPolyhedron& other);

  std::span<const Index> vertices() const { return {inside_.data(), inside_count_}; }
  Vector<3> position(Index vertex) const {
    const Vertex& v = vertex_[vertex];
    return {v.x, v.y, v.z};
  }

  /// Computes the depths of the vertices behind a plane, before a cut.
  DepthRange sound(const Halfspace<3>& plane);
  /// Keeps what is behind that plane. Vertices in the plane are kept.
  void cut();

  VolumeAndMoment measure();
  VolumeAndSpread measure_with_spread();

 private:
  struct Vertex {
    double x, y, z;
    double depth;  // behind the cutting plane
  };

  // Half-edges 4 v, 4 v + 1 and 4 v + 2 leave vertex v, counter-clockwise seen from outside.
  static Index clockwise(Index half) { return (half & 3) == 0 ? half + 2 : half - 1; }

  void make_room(std::size_t vertices) {
    if (walked_.size() < 4 * vertices) gain_room_for(vertices);
  }
  void gain_room_for(std::size_t vertices);
  void add_block_vertex(const Outline<3>& block, std::int32_t v, double depth);
  void join_block_vertices(const Outline<3>& block);
  void clip();
  void place_crossing(Index vertex, Index inner_half);
  template <class Sums>
  Sums sum_up();

  Array<Vertex> vertex_;
  Array<Index> twin_;             // the opposite half-edge
  Array<Index> inside_;           // the vertices that are left
  Array<Index> crossing_;         // half-edges that leave inside for outside
  Array<std::uint8_t> walked_;    // half-edges measured already
  Array<Index> first_of_vertex_;  // index of the first vertex of each of the block's
  Array<Index> half_of_edge_;     // half-edges of each of the block's edges, from its end and from its start
  Index vertex_count_ = 0;        // including those cut off
  std::size_t inside_count_ = 0;
};

}  // namespace halfspace
