#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow_phase/space/seen_outline.h"

namespace halfspace {

/// Coordinates on a plane, counter-clockwise about its unit normal.
struct PlaneFrame {
  Vector<3> normal;
  Vector<3> origin;
  Vector<3> along;
  Vector<3> across;

  /// The first axis is normal to the coordinate axis most nearly in the plane, which keeps it accurate.
  PlaneFrame(const Vector<3>& unit_normal, const Vector<3>& point) : normal(unit_normal), origin(point) {
    int least = 0;
    normal.cwiseAbs().minCoeff(&least);
    along = cross_product(normal, Vector<3>::Unit(least)).normalized();
    across = cross_product(normal, along);
  }

  Vector<2> in_plane(const Vector<3>& direction) const {
    return {along.dot(direction), across.dot(direction)};
  }
  Vector<2> foot_of(const Vector<3>& p) const { return in_plane(p - origin); }
  Vector<3> at(const Vector<2>& p) const { return origin + (p.x() * along + p.y() * across); }
  Tensor<3> in_space(const Tensor<2>& tensor) const {
    Eigen::Matrix<double, 3, 2> axes;
    axes << along, across;
    return axes * tensor * axes.transpose();
  }
};

/// A face projected along the normal of a plane to which it is nearly parallel. The corners of large faces
/// are computed on demand, so that their number is not limited.
class FlatFace {
 public:
  FlatFace(const PlaneFrame& plane, const SeenOutline& block, int face, const Vector<3>& to_block)
      : plane_(plane),
        block_(block),
        shift_(to_block),
        first_(block.topology->first_of_face[face]),
        count_(block.topology->first_of_face[face + 1] - first_),
        is_opposed_(block.normal(face).dot(plane.normal) < 0) {
    for (int i = 0; i < std::min(count_, max_known_corners); ++i) corner_[i] = projected_corner(i);
  }

  int count() const { return count_; }
  int next(int i) const { return i + 1 == count_ ? 0 : i + 1; }
  /// Counter-clockwise about the plane's normal.
  Vector<2> corner(int i) const { return i < max_known_corners ? corner_[i] : projected_corner(i); }
  /// The index of the corner among the block's vertices.
  int vertex(int i) const {
    return block_.topology->face_vertex[first_ + (is_opposed_ ? count_ - 1 - i : i)];
  }

 private:
  static constexpr int max_known_corners = 32;

  Vector<2> projected_corner(int i) const { return plane_.foot_of(block_.vertex(vertex(i)) + shift_); }

  const PlaneFrame& plane_;
  const SeenOutline& block_;
  Vector<3> shift_;
  int first_;
  int count_;
  bool is_opposed_;
  Vector<2> corner_[max_known_corners];
};

/// The half-plane left of a line through two points, in coordinates on a plane. Points within rounding of the
/// line are on it, so that edges that coincide to rounding have no crossing.
struct HalfPlane {
  Vector<2> start;
  Vector<2> outward;  // its length is the distance of the points
  double rounding;

  HalfPlane(const Vector<2>& from, const Vector<2>& to, double rounding_of_points)
      : start(from),
        outward(-perpendicular(to - from)),
        rounding(rounding_of_points * outward.cwiseAbs().sum()) {}

  /// Distance outward, times the length of `outward`.
  double height(const Vector<2>& p) const { return outward.dot(p - start); }
};

}  // namespace halfspace
