#pragma once

#include "detect/edge_pairs.h"
#include "geometry/outline.h"
#include "geometry/rotation.h"

namespace halfspace {

/// The outline of a block of up to most_edges_in_set edges turned into another frame, on the stack.
class TurnedPolyhedron {
 public:
  TurnedPolyhedron(const Outline<3>& given, const Rotation<3>& rotation) {
    const int vertices = Outline<3>::padded(given.vertex_count());
    const int faces = Outline<3>::padded(given.face_count());
    for (int v = 0; v < vertices; ++v) put(rotation * given.vertex(v), v, x_, y_, z_);
    for (int f = 0; f < faces; ++f) put(rotation * given.normal(f), f, nx_, ny_, nz_);
    outline_ = {given.topology, x_, y_, z_, nx_, ny_, nz_, given.offset};
  }
  TurnedPolyhedron(const TurnedPolyhedron&) = delete;  // the outline points into it
  TurnedPolyhedron& operator=(const TurnedPolyhedron&) = delete;

  const Outline<3>& outline() const { return outline_; }

 private:
  /// A polyhedron has at least three edges for every two vertices, and for every two faces.
  static constexpr int most = Outline<3>::padded(2 * most_edges_in_set / 3);

  static void put(const Vector<3>& v, int i, double* x, double* y, double* z) {
    x[i] = v.x();
    y[i] = v.y();
    z[i] = v.z();
  }

  double x_[most], y_[most], z_[most];
  double nx_[most], ny_[most], nz_[most];
  Outline<3> outline_;
};

}  // namespace halfspace
