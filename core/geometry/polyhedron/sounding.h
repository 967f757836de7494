#pragma once

#include "geometry/halfspace.h"
#include "geometry/outline.h"

namespace halfspace {

struct DepthRange {
  double least;
  double most;
};

/// Writes the depths of points behind a plane, two at a time: all arrays have room for an even number.
DepthRange sound(std::size_t count, const double* x, const double* y, const double* z,
                 const Halfspace<3>& plane, double* depths);

/// The depths of a block's vertices behind a plane, computed before a cut.
class VertexDepths {
 public:
  explicit VertexDepths(Memory* memory) : depth_(memory) {}

  DepthRange take(const Outline<3>& block, const Halfspace<3>& plane) {
    const std::size_t count = std::size_t(block.vertex_count());
    reserve(count);
    return sound(count, block.x, block.y, block.z, plane, depth_.data());
  }

  void reserve(std::size_t vertices) {
    if (depth_.size() < vertices + 1) depth_.resize(vertices + 1);
  }

  double depth(int vertex) const { return depth_[std::size_t(vertex)]; }

 private:
  Array<double> depth_;
};

}  // namespace halfspace
