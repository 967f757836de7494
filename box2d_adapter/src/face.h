#pragma once

#include "placement.h"
#include "polygon.h"

namespace halfspace::box2d {

/// An edge of one of two polygons, called a face in Box2D. The deepest vertex of the other polygon is
/// relative to its half-space.
struct Face {
  int owner = 0;  // 0 polygon a, 1 polygon b
  int edge = 0;
  friend bool operator==(const Face&, const Face&) = default;
};

/// The two polygons of a pair, in the frame of the owner of a face.
struct SeenFromFace {
  SeenFromFace(const Polygon& a, const Polygon& b, const Placement& b_from_a, const Face& face)
      : owner(face.owner == 0 ? a : b),
        other(face.owner == 0 ? b : a),
        at(face.owner == 0 ? b_from_a : inverse(b_from_a)),
        edge(face.edge) {}

  /// The face's normal in the frame of the other polygon.
  Vector normal_in_other() const { return at.turn.inverse() * owner.normal(edge); }
  /// Signed distance of a vertex of the other polygon from the face.
  double gap(int vertex) const {
    return (dot(normal_in_other(), other.vertex(vertex)) + dot(owner.normal(edge), at.shift)) -
           owner.offset(edge);
  }

  const Polygon& owner;
  const Polygon& other;
  Placement at;  // of the other polygon, in the frame of the owner
  int edge;
};

/// The vertex of the other polygon with the smallest signed distance from the face.
inline int deepest_vertex(const SeenFromFace& seen) {
  const Vector normal = seen.normal_in_other();
  int deepest = 0;
  double least = dot(normal, seen.other.vertex(0));
  for (int v = 1; v < seen.other.count(); ++v) {
    const double height = dot(normal, seen.other.vertex(v));
    if (height < least) {
      least = height;
      deepest = v;
    }
  }
  return deepest;
}

/// The incident edge: the edge of the other polygon whose normal is the most antiparallel. It is one of the
/// two edges at the deepest vertex, as normals are sorted by angle.
inline int incident_edge(const SeenFromFace& seen, int deepest) {
  const Vector normal = seen.normal_in_other();
  const int before = seen.other.previous(deepest);
  return dot(normal, seen.other.normal(before)) < dot(normal, seen.other.normal(deepest)) ? before : deepest;
}

}  // namespace halfspace::box2d
