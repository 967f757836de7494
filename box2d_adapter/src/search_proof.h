#pragma once

#include <cmath>

#include "face.h"

namespace halfspace::box2d {

/// The result of a search over all faces of two polygons, valid while the bound on the motion since then,
/// which also bounds the change of every gap, is small enough. Polygons at rest need no new search.
class SearchProof {
 public:
  SearchProof() = default;
  /// `largest` is the largest gap of all faces, or a gap above the sum of the skins; `surplus` is the margin
  /// by which the gap of the reference face may decrease until another face is preferred.
  SearchProof(const Polygon& a, const Polygon& b, const Placement& b_from_a, double largest,
              double surplus = -1)
      : at_(b_from_a),
        reach_(a.radius() + b.radius() + std::abs(b_from_a.shift.x) + std::abs(b_from_a.shift.y)),
        largest_(largest),
        surplus_(surplus) {}

  /// Upper bound of the change of a gap. A rotation displaces a point by its radius times the chord of the
  /// angle, the norm of the change of (cosine, sine), here the 1-norm. In the frame of b, a also moves with
  /// the rotation of b, about the centroid of b.
  double max_change(const Placement& now) const {
    const double chord =
        std::abs(now.turn.cosine - at_.turn.cosine) + std::abs(now.turn.sine - at_.turn.sine);
    const Vector moved = now.shift - at_.shift;
    return reach_ * chord + (std::abs(moved.x) + std::abs(moved.y));
  }

  bool still_separated(double change, double radii) const { return largest_ - change > radii; }

  /// Still in contact with the same reference face? The largest gap may have increased, and that of the face
  /// decreased.
  bool still_at_same_face(double change, double radii) const {
    return largest_ + change <= radii && 2 * change <= surplus_;
  }

 private:
  Placement at_;
  double reach_ = 0;
  double largest_ = 0;
  double surplus_ = -1;
};

}  // namespace halfspace::box2d
