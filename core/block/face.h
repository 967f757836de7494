#pragma once

#include "geometry/outline.h"
#include "geometry/vector.h"

namespace halfspace {

/// A face of a block; in 2D an edge.
template <int D>
struct Face {
  double area;
  Vector<D> centroid;
};

inline Face<2> face_of(const Outline<2>& outline, int edge) {
  const Vector<2> from = outline.vertex(edge), to = outline.vertex(outline.next(edge));
  return {(to - from).norm(), 0.5 * (from + to)};
}

inline Face<3> face_of(const Outline<3>& outline, int face) {
  const Topology& topology = *outline.topology;
  const int first = topology.first_of_face[face], past = topology.first_of_face[face + 1];
  const auto corner = [&](int k) { return outline.vertex(topology.face_vertex[k]); };
  const Vector<3> origin = corner(first);
  Face<3> sum{0, Vector<3>::Zero()};
  for (int k = first + 1; k + 1 < past; ++k) {
    const Vector<3> p = corner(k) - origin, q = corner(k + 1) - origin;
    const double area = 0.5 * cross_product(p, q).norm();
    sum.area += area;
    sum.centroid += area / 3 * (p + q);
  }
  sum.centroid = origin + sum.centroid / sum.area;
  return sum;
}

}  // namespace halfspace
