#pragma once

#include "geometry/rotation.h"
#include "geometry/vector.h"

namespace halfspace {

/// How a block moves over an interval whose time runs from 0 to 1: its centroid goes straight, the block
/// turns evenly about it, and seen from what turns with it its gradient changes evenly. A rigid block has a
/// rotation as gradient and no stretch; an affine block, as the world moves it, does not turn but stretch. At
/// a time its points are at position + time way + R(time turn) (gradient + time stretch) X, X their place in
/// the shape's frame.
template <int D>
struct Sweep {
  Vector<D> position = Vector<D>::Zero();      // of the centroid at the start
  Vector<D> way = Vector<D>::Zero();           // of the centroid
  Tensor<D> gradient = Tensor<D>::Identity();  // at the start
  Angular<D> turn = Angular<D>::Zero();        // as far as one likes, also beyond a full one
  Tensor<D> stretch = Tensor<D>::Zero();       // of the gradient, by the end

  Tensor<D> turned_by(double time) const { return Rotation<D>().turned_by(time * turn).tensor(); }
  Tensor<D> gradient_at(double time) const { return turned_by(time) * stretched_at(time); }
  /// Seen from what turns with the block.
  Tensor<D> stretched_at(double time) const { return gradient + time * stretch; }
};

}  // namespace halfspace
