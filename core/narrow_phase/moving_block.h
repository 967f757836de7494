#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "geometry/deformed_outline.h"
#include "geometry/outline.h"
#include "geometry/vector.h"
#include "narrow_phase/plane/separation.h"
#include "narrow_phase/space/support.h"
#include "narrow_phase/sweep.h"

namespace halfspace {

/// Bounds of the positions of a block's points, for the bound of their heights' second derivatives.
struct Reach {
  double radius = 0;   // about the centroid, at any time
  double across = 0;   // about the rotation axis through the centroid, at any time
  double stretch = 0;  // the largest displacement of a point by the stretch
};

/// A block that moves over an interval, relative to its centroid. `room` has component_count() doubles for
/// its outline.
template <int D>
class MovingBlock {
 public:
  MovingBlock(const Outline<D>& own, const Sweep<D>& sweep, double* room)
      : own_(own), sweep_(sweep), angle_(sweep.turn.norm()), room_(room) {
    measure();
  }

  const Reach& reach() const { return reach_; }
  double angle() const { return angle_; }
  const Angular<D>& turn() const { return sweep_.turn; }

  /// The outline at a time. Valid until the next call.
  Outline<D> outline_at(double time) { return deformed(own_, sweep_.gradient_at(time), room_); }

  /// The height of the deepest point along a direction at a time.
  double depth_along(const Vector<D>& direction, double time) const {
    return deepest_along(Vector<D>(sweep_.gradient_at(time).transpose() * direction));
  }

  /// The velocity gradient of the stretch alone at a time.
  Tensor<D> stretching_at(double time) const {
    const Tensor<D> turned = sweep_.turned_by(time);
    return turned * sweep_.stretch * sweep_.stretched_at(time).inverse() * turned.transpose();
  }

  /// Bound of the second derivative of a point's height along a normal that rotates by `turn` in the
  /// interval: in the frame of the normal, a point y has the second derivative ((w - u)^2 + [u w]) y + 2 (u -
  /// w) s, with the cross tensors w of the normal's rotation and u of the block's, and the rate s of the
  /// stretch.
  double bend(const Angular<D>& turn) const {
    const Angular<D> slip = turn - sweep_.turn;
    const double speed = slip.norm();
    if constexpr (D == 2) {
      return speed * (speed * reach_.radius + 2 * reach_.stretch);
    } else {
      const Vector<3> axis = angle_ > 0 ? Vector<3>(sweep_.turn / angle_) : Vector<3>::Zero();
      const double along = slip.dot(axis);
      const double swept = std::abs(along) * reach_.across + (slip - along * axis).norm() * reach_.radius;
      return speed * (swept + 2 * reach_.stretch) + cross_product(sweep_.turn, turn).norm() * reach_.radius;
    }
  }

 private:
  void measure() {
    const Tensor<D> end = sweep_.stretched_at(1);
    for (int i = 0; i < own_.vertex_count(); ++i) {
      const Vector<D> vertex = own_.vertex(i);
      const Vector<D> at_start = sweep_.gradient * vertex, at_end = end * vertex;
      reach_.radius = std::max({reach_.radius, at_start.squaredNorm(), at_end.squaredNorm()});
      reach_.stretch = std::max(reach_.stretch, (at_end - at_start).squaredNorm());
      if constexpr (D == 3) {
        reach_.across = std::max({reach_.across, cross_product(sweep_.turn, at_start).squaredNorm(),
                                  cross_product(sweep_.turn, at_end).squaredNorm()});
      }
    }
    reach_.radius = std::sqrt(reach_.radius);
    reach_.stretch = std::sqrt(reach_.stretch);
    reach_.across = D == 3 && angle_ > 0 ? std::sqrt(reach_.across) / angle_ : reach_.radius;
  }

  double deepest_along(const Vector<2>& direction) const {
    return halfspace::height_along(direction, own_, deepest_vertex(own_, direction, 0));
  }
  double deepest_along(const Vector<3>& direction) const { return deepest(own_, direction).height; }

  const Outline<D>& own_;
  const Sweep<D>& sweep_;
  double angle_;
  Reach reach_;
  double* room_;
};

}  // namespace halfspace
