#pragma once

#include "geometry/outline.h"
#include "geometry/rotation.h"
#include "narrow_phase/space/sat_edges.h"
#include "simd/two_lanes.h"

namespace halfspace {

/// The outline of a block of up to max_edges_in_set edges rotated to another frame, in its own memory.
class TurnedPolyhedron {
 public:
  TurnedPolyhedron(const Outline<3>& given, const Rotation<3>& rotation) {
    const int vertices = Outline<3>::padded(given.vertex_count());
    const int faces = Outline<3>::padded(given.face_count());
    double *const x = components_, *const y = x + vertices, *const z = y + vertices;
    double *const nx = z + vertices, *const ny = nx + faces, *const nz = ny + faces;
    turn(rotation, given.x, given.y, given.z, vertices, x, y, z);
    turn(rotation, given.nx, given.ny, given.nz, faces, nx, ny, nz);
    outline_ = {given.topology, x, y, z, nx, ny, nz, given.offset, nullptr};
  }
  TurnedPolyhedron(const TurnedPolyhedron&) = delete;  // the outline points into it
  TurnedPolyhedron& operator=(const TurnedPolyhedron&) = delete;

  const Outline<3>& outline() const { return outline_; }

 private:
  /// Vertices and faces are the edges plus two (Euler), each padded.
  static constexpr int max_components = 3 * (max_edges_in_set + 2 + 2 * 3);

  /// Two at a time, with the same bits as Rotation.
  static void turn(const Rotation<3>& rotation, const double* x, const double* y, const double* z, int count,
                   double* turned_x, double* turned_y, double* turned_z) {
    const Vector<3> axes[] = {rotation * Vector<3>::UnitX(), rotation * Vector<3>::UnitY(),
                              rotation * Vector<3>::UnitZ()};
    for (int i = 0; i < count; i += 2) {
      const TwoLanes px = load_two(x + i), py = load_two(y + i), pz = load_two(z + i);
      const auto component = [&](int c) {
        return px * both(axes[0][c]) + py * both(axes[1][c]) + pz * both(axes[2][c]);
      };
      store_two(turned_x + i, component(0));
      store_two(turned_y + i, component(1));
      store_two(turned_z + i, component(2));
    }
  }

  double components_[max_components];
  Outline<3> outline_;
};

}  // namespace halfspace
