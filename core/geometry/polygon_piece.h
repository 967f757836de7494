#pragma once

#include "geometry/piece_vertices.h"
#include "geometry/sounding.h"

namespace halfspace {

/// The corners of a convex polygon in space, counter-clockwise as it is to be seen.
struct PolygonView {
  int vertex_count;
  const double* x;
  const double* y;
  const double* z;
};

/// A part of a polygon, as cuts leave it: two corners may be one point.
class PolygonPiece {
 public:
  class Cutter;

  explicit PolygonPiece(Memory* memory) : vertices_(memory) {}

  PolygonView view() const { return {vertices_.count(), vertices_.x(), vertices_.y(), vertices_.z()}; }
  PieceVertices& vertices() { return vertices_; }
  /// For a face of a polyhedron of so many faces.
  void reserve(std::size_t faces) { vertices_.reserve(4 * faces); }

 private:
  PieceVertices vertices_;
};

/// Parts polygons at planes.
class PolygonPiece::Cutter {
 public:
  explicit Cutter(Memory*) {}
  void reserve(std::size_t) {}

  /// Both parts get the same new corners, so that together they are the whole. Corners in the plane are
  /// inside; the outside gets new ones there.
  void part(const PolygonView& whole, const Sounding& sounding, PolygonPiece& inside, PolygonPiece& outside);
  void keep_inside(const PolygonView& whole, const Sounding& sounding, PolygonPiece& inside);
};

/// Of the cone from the origin: negative when the polygon looks towards it.
VolumeAndMoment measure(const PolygonView& base);

}  // namespace halfspace
