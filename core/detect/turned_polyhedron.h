#pragma once

#include "detect/edge_pairs.h"
#include "geometry/outline.h"
#include "geometry/rotation.h"

namespace halfspace {

/// The outline of a block turned into another frame, in memory of its own: on the stack for blocks of up to
/// most_edges_in_set edges.
class TurnedPolyhedron {
 public:
  TurnedPolyhedron(const Outline<3>& given, const Rotation<3>& rotation,
                   Memory* memory = std::pmr::null_memory_resource())
      : memory_(memory) {
    const int vertices = Outline<3>::padded(given.vertex_count());
    const int faces = Outline<3>::padded(given.face_count());
    count_ = 3 * (vertices + faces);
    components_ =
        count_ <= most_inline ? inline_ : static_cast<double*>(memory_->allocate(bytes(), alignof(double)));
    double *const x = components_, *const y = x + vertices, *const z = y + vertices;
    double *const nx = z + vertices, *const ny = nx + faces, *const nz = ny + faces;
    for (int v = 0; v < vertices; ++v) put(rotation * given.vertex(v), v, x, y, z);
    for (int f = 0; f < faces; ++f) put(rotation * given.normal(f), f, nx, ny, nz);
    outline_ = {given.topology, x, y, z, nx, ny, nz, given.offset};
  }
  ~TurnedPolyhedron() {
    if (components_ != inline_) memory_->deallocate(components_, bytes(), alignof(double));
  }
  TurnedPolyhedron(const TurnedPolyhedron&) = delete;  // the outline points into it
  TurnedPolyhedron& operator=(const TurnedPolyhedron&) = delete;

  const Outline<3>& outline() const { return outline_; }

 private:
  /// Vertices and faces are two more than the edges (Euler), each padded.
  static constexpr int most_inline = 3 * (most_edges_in_set + 2 + 2 * 3);

  static void put(const Vector<3>& v, int i, double* x, double* y, double* z) {
    x[i] = v.x();
    y[i] = v.y();
    z[i] = v.z();
  }
  std::size_t bytes() const { return std::size_t(count_) * sizeof(double); }

  Memory* memory_;
  int count_;
  double* components_;
  double inline_[most_inline];
  Outline<3> outline_;
};

}  // namespace halfspace
