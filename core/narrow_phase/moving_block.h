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

/// How far a block's points reach, and what bounds how their heights bend.
struct Reach {
  double radius = 0;   // about the centroid, at any time
  double across = 0;   // about the axis of the turn through the centroid, at any time
  double stretch = 0;  // how far the stretch takes a point
};

/// A block that moves over an interval, seen from its centroid. Its outline is laid down in `room`, of
/// component_count() doubles.
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

  /// As it is at a time. Valid until the next call.
  Outline<D> outline_at(double time) { return deformed(own_, sweep_.gradient_at(time), room_); }

  /// How deep it lies along a direction at a time.
  double depth_along(const Vector<D>& direction, double time) const {
    return deepest_along(Vector<D>(sweep_.gradient_at(time).transpose() * direction));
  }

  /// How fast the stretch alone moves places about the centroid at a time.
  Tensor<D> stretching_at(double time) const {
    const Tensor<D> turned = sweep_.turned_by(time);
    return turned * sweep_.stretch * sweep_.stretched_at(time).inverse() * turned.transpose();
  }

  /// Bound of how much the height of a point bends along a normal that turns by `turn` in the interval: seen
  /// from what turns with the normal, a point at y has the second derivative ((w - u)^2 + [u w]) y + 2 (u -
  /// w) s, in which w and u stand for the cross tensors of the normal's turn and of the block's and s is the
  /// stretch's rate.
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
