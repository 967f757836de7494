#pragma once

// Convex polyhedra of the tests' own, made by CGAL's exact hull, and where they are.

#include <halfspace/halfspace.h>

#include "oracles/vector_3d.h"

namespace halfspace_test {

/// The convex hull of its vertices. Faces are whole: triangles that are in one plane exactly are one face.
struct Polyhedron {
  struct Edge {
    int from;
    int to;
    int left;   ///< the face on the left on the way, seen from outside
    int right;  ///< the other face
  };
  Points3 vertices;
  std::vector<std::vector<int>> faces;  ///< vertices, counter-clockwise seen from outside
  std::vector<Edge> edges;
  Point3 centre;  ///< what a pose puts at its position; inside
};

/// The hull, exact on the doubles given, about the mean of its vertices, which keep their order. Without
/// faces if the points are in one plane.
Polyhedron convex_hull(const Points3& points);

/// Vertices about the centre, rounded once.
Points3 local_vertices(const Polyhedron& polyhedron);

/// Three vertices of a face in its sense of rotation, the ones with the widest corner.
struct Corner {
  int before;
  int here;
  int after;
};
Corner widest_corner(const Polyhedron& polyhedron, const std::vector<int>& face);

struct PlacedPolyhedron {
  const Polyhedron* polyhedron;
  hs_pose pose;
};

/// The turn of a quaternion of any length: its matrix times the squared length, which is polynomial.
template <class Number>
class Turn3 {
 public:
  explicit Turn3(const hs_pose& pose) {
    const Number x(pose.rotation[0]), y(pose.rotation[1]), z(pose.rotation[2]), w(pose.rotation[3]);
    const Number two(2);
    row_[0] = {w * w + x * x - y * y - z * z, two * (x * y - w * z), two * (x * z + w * y)};
    row_[1] = {two * (x * y + w * z), w * w - x * x + y * y - z * z, two * (y * z - w * x)};
    row_[2] = {two * (x * z - w * y), two * (y * z + w * x), w * w - x * x - y * y + z * z};
    length_squared_ = x * x + y * y + z * z + w * w;
  }

  Vector3<Number> turned(const Vector3<Number>& v) const {
    return {dot(row_[0], v), dot(row_[1], v), dot(row_[2], v)};
  }
  Vector3<Number> turned_back(const Vector3<Number>& v) const {
    return v.x * row_[0] + v.y * row_[1] + v.z * row_[2];
  }
  const Number& length_squared() const { return length_squared_; }

 private:
  Vector3<Number> row_[3];
  Number length_squared_;
};

/// Everything seen from a, about its centre, and times scale(): no division.
template <class Number>
class PairFrame {
 public:
  PairFrame(const PlacedPolyhedron& a, const PlacedPolyhedron& b) : turn_a_(a.pose), turn_b_(b.pose) {
    scale_ = turn_a_.length_squared() * turn_b_.length_squared();
    const Vector3<Number> apart = position(b.pose) - position(a.pose);
    apart_ = turn_b_.length_squared() * turn_a_.turned_back(apart);
  }

  Vector3<Number> point_of_a(const PlacedPolyhedron& a, const Point3& vertex) const {
    return scale_ * (converted<Number>(vertex) - converted<Number>(a.polyhedron->centre));
  }
  Vector3<Number> point_of_b(const PlacedPolyhedron& b, const Point3& vertex) const {
    return apart_ + direction_of_b(converted<Number>(vertex) - converted<Number>(b.polyhedron->centre));
  }
  Vector3<Number> direction_of_b(const Vector3<Number>& in_b) const {
    return turn_a_.turned_back(turn_b_.turned(in_b));
  }
  /// From the centre of a to that of b.
  const Vector3<Number>& apart() const { return apart_; }
  const Number& scale() const { return scale_; }

 private:
  static Vector3<Number> position(const hs_pose& pose) {
    return {Number(pose.position[0]), Number(pose.position[1]), Number(pose.position[2])};
  }

  Turn3<Number> turn_a_;
  Turn3<Number> turn_b_;
  Number scale_;
  Vector3<Number> apart_;
};

}  // namespace halfspace_test
