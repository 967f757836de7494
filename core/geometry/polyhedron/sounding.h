#pragma once

#include "geometry/outline.h"

namespace halfspace {

/// Inside is where the depth is not negative. The normal has any length.
struct CuttingPlane {
  Vector<3> normal;
  double offset;

  double depth(const Vector<3>& p) const { return offset - normal.dot(p); }
};

struct DepthRange {
  double least;
  double most;
};

/// How deep each vertex of a block lies behind a plane: what is known before it is cut there.
class Sounding {
 public:
  explicit Sounding(Memory* memory) : depth_(memory) {}

  DepthRange take(const Outline<3>& block, const CuttingPlane& plane) {
    return take(std::size_t(block.vertex_count()), block.x, block.y, block.z, plane);
  }

  void reserve(std::size_t vertices) {
    if (depth_.size() < vertices + 1) depth_.resize(vertices + 1);
  }

  double depth(int vertex) const { return depth_[std::size_t(vertex)]; }

 private:
  DepthRange take(std::size_t count, const double* x, const double* y, const double* z,
                  const CuttingPlane& plane);

  Array<double> depth_;
};

}  // namespace halfspace
