#pragma once

#include <Eigen/LU>
#include <cmath>
#include <optional>

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

inline double volume_bend(const Tensor<2>&) { return 0; }
inline double volume_bend(const Tensor<3>& change) { return change.determinant(); }

/// A time on the way at which a shape is flat or inside out, and its volume then as a share of that at first.
struct Collapse {
  double time;
  double volume;
};

/// A stretch may turn a shape inside out between its start and its end. Its volume on the way is a polynomial
/// in the invariants of the change, which is least where its derivative is 0.
template <int D>
std::optional<Collapse> collapse_on_the_way(const Tensor<D>& gradient, const Tensor<D>& stretch) {
  const Tensor<D> change = gradient.inverse() * stretch;
  const double c1 = change.trace(), c2 = 0.5 * (c1 * c1 - (change * change).trace()),
               c3 = volume_bend(change);
  const double square = c2 * c2 - 3 * c3 * c1;
  if (square < 0) return {};
  const double sum = -(c2 + std::copysign(std::sqrt(square), c2));
  const double times[] = {c3 != 0 ? sum / (3 * c3) : 0, sum != 0 ? c1 / sum : 0};
  for (const double time : times) {
    const double volume = 1 + time * (c1 + time * (c2 + time * c3));
    if (time > 0 && time < 1 && !(volume > 0)) return Collapse{time, volume};
  }
  return {};
}

}  // namespace halfspace
