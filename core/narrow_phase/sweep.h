#pragma once

#include <Eigen/LU>
#include <cmath>
#include <optional>

#include "geometry/rotation.h"
#include "geometry/vector.h"

namespace halfspace {

/// The motion of a block in an interval of time 0 to 1: its centroid moves on a straight line, the block
/// rotates at a constant rate about it, and in the rotating frame its gradient changes at a constant rate. A
/// rigid block has a rotation as gradient and no stretch; an affine block has no rotation but stretch. A
/// point X of the shape's frame is at position + time way + R(time turn) (gradient + time stretch) X.
template <int D>
struct Sweep {
  Vector<D> position = Vector<D>::Zero();      // of the centroid at the start
  Vector<D> way = Vector<D>::Zero();           // displacement of the centroid
  Tensor<D> gradient = Tensor<D>::Identity();  // at the start
  Angular<D> turn = Angular<D>::Zero();        // rotation vector, of any length
  Tensor<D> stretch = Tensor<D>::Zero();       // total change of the gradient

  Tensor<D> turned_by(double time) const { return Rotation<D>().turned_by(time * turn).tensor(); }
  Tensor<D> gradient_at(double time) const { return turned_by(time) * stretched_at(time); }
  /// In the rotating frame.
  Tensor<D> stretched_at(double time) const { return gradient + time * stretch; }
};

inline double volume_bend(const Tensor<2>&) { return 0; }
inline double volume_bend(const Tensor<3>& change) { return change.determinant(); }

/// A time at which a shape is flat or inverted, and its volume relative to the initial one.
struct Collapse {
  double time;
  double volume;
};

/// A stretch may invert a shape between its start and its end. The volume is a polynomial in the invariants
/// of the change, and its minimum is where the derivative is 0.
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
