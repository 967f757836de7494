#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/outline.h"
#include "geometry/piece_vertices.h"
#include "geometry/sounding.h"

namespace halfspace {

/// A convex polyhedron to be read as vertices and loops of them around the faces, wherever they are stored.
struct PolyhedronView {
  int vertex_count;
  int face_count;
  int old_face_count;  // the first ones: of what was cut; the others are in the planes that cut it
  const double* x;
  const double* y;
  const double* z;
  const std::int32_t* first_of_face;  // face_count + 1
  const std::int32_t* corner;         // counter-clockwise seen from outside
};

inline PolyhedronView view_of(const Outline<3>& block) {
  const Topology& t = *block.topology;
  return {t.vertex_count, t.face_count, t.face_count,    block.x,
          block.y,        block.z,      t.first_of_face, t.face_vertex};
}

/// A part of a polyhedron, as cuts leave it: edges may have no length and faces no area, but the surface is
/// closed.
class PolyhedronPiece {
 public:
  class Cutter;

  explicit PolyhedronPiece(Memory* memory)
      : vertices_(memory), first_of_face_(1, 0, memory), corner_(memory) {}

  /// For a part of a polyhedron that has no more faces than this, the cuts' own included.
  void reserve(std::size_t faces) { make_room(most_vertices(faces), most_edges(faces), faces); }

  PolyhedronView view() const {
    return {vertices_.count(), face_count_,   old_face_count_,       vertices_.x(),
            vertices_.y(),     vertices_.z(), first_of_face_.data(), corner_.data()};
  }

 private:
  /// By Euler's formula.
  static constexpr std::size_t most_vertices(std::size_t faces) { return 2 * faces; }
  static constexpr std::size_t most_edges(std::size_t faces) { return 3 * faces; }

  void make_room(std::size_t vertices, std::size_t edges, std::size_t faces);
  /// Empties it, and makes room for a part of a whole: each edge may be crossed.
  void begin(const PolyhedronView& whole);
  void add_corner(std::int32_t vertex, bool belongs = true) {
    *corner_end_ = vertex;
    corner_end_ += belongs;
  }
  /// The corners added since the last face are one more; of less than three there is none.
  void end_face();
  /// All faces of what was cut have been added.
  void end_old_faces() { old_face_count_ = face_count_; }

  PieceVertices vertices_;
  Array<std::int32_t> first_of_face_;  // begins with 0
  Array<std::int32_t> corner_;
  std::int32_t* corner_end_ = nullptr;
  int face_count_ = 0;
  int old_face_count_ = 0;
};

/// Parts polyhedra at planes.
class PolyhedronPiece::Cutter {
 public:
  explicit Cutter(Memory* memory) : place_(memory), crossings_(memory) {}
  void reserve(std::size_t faces) {
    place_.reserve(most_vertices(faces));
    crossings_.reserve(most_edges(faces));
  }

  /// Both parts get the same new vertices, so that together they are the whole, and the new face. Vertices in
  /// the plane are inside; the outside gets new ones there.
  void part(const PolyhedronView& whole, const Sounding& sounding, PolyhedronPiece& inside,
            PolyhedronPiece& outside);
  void keep_inside(const PolyhedronView& whole, const Sounding& sounding, PolyhedronPiece& inside);

 private:
  struct NoPiece;

  /// Where the plane crosses an edge. The outline of the face on one side of it goes one way, that of the
  /// other is awaited to come the other way.
  struct Crossing {
    std::int32_t awaited_from;  // vertices of the whole; -1 when both have come
    std::int32_t awaited_to;
    std::int32_t inside;  // the new vertex in either part
    std::int32_t outside;
    std::int32_t next_inside;  // in the new face of either part; -1 once that is made
    std::int32_t next_outside;
  };

  template <class Outside>
  void part_at_plane(const PolyhedronView& whole, const Sounding& sounding, PolyhedronPiece& inside,
                     Outside& outside);
  template <class Outside>
  void place_vertices(const PolyhedronView& whole, const Sounding& sounding, PolyhedronPiece& inside,
                      Outside& outside);
  template <class Outside>
  bool take_face(const PolyhedronView& whole, int face, PolyhedronPiece& inside, Outside& outside);
  template <class Outside>
  void part_face(const PolyhedronView& whole, int face, const Sounding& sounding, PolyhedronPiece& inside,
                 Outside& outside);
  template <class Outside>
  std::int32_t cross(const PolyhedronView& whole, std::int32_t from, std::int32_t to,
                     const Sounding& sounding, PolyhedronPiece& inside, Outside& outside);
  template <class Outside>
  void close(PolyhedronPiece& inside, Outside& outside);

  std::int32_t place(std::int32_t vertex) const { return place_[std::size_t(vertex)]; }
  bool is_inside(std::int32_t vertex) const { return place(vertex) >= 0; }

  Array<std::int32_t> place_;  // of a vertex inside; outside ~ of it
  Array<Crossing> crossings_;
};

VolumeAndMoment measure(const PolyhedronView& piece);

}  // namespace halfspace
