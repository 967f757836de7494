#pragma once

#include <cmath>

#include "face.h"

namespace halfspace::box2d {

/// What a search over all faces of two polygons has found, and how long it holds: no gap changes by more than
/// the polygons have moved since. At rest they hardly move, and there is nothing to search.
class SearchProof {
 public:
  SearchProof() = default;
  /// `largest` is the largest gap of all faces, or one above the radii of the skins; `surplus` by how much
  /// the reference face of a contact could be worse and still be taken.
  SearchProof(const Polygon& a, const Polygon& b, const Placement& b_from_a, double largest,
              double surplus = -1)
      : at_(b_from_a),
        reach_(a.radius() + b.radius() + std::abs(b_from_a.shift.x) + std::abs(b_from_a.shift.y)),
        largest_(largest),
        surplus_(surplus) {}

  /// The most that a gap can have changed. A turn moves a point by its radius times the chord of the angle,
  /// the length by which the unit vector of the turn has changed, here summed over components. Seen from b,
  /// a moves with the turn of b as well, about the centroid of b.
  double most_change(const Placement& now) const {
    const double chord =
        std::abs(now.turn.cosine - at_.turn.cosine) + std::abs(now.turn.sine - at_.turn.sine);
    const Vector moved = now.shift - at_.shift;
    return reach_ * chord + (std::abs(moved.x) + std::abs(moved.y));
  }

  bool still_separated(double change, double radii) const { return largest_ - change > radii; }

  /// In contact, and at the same reference face: the largest gap may have grown, and that of the face shrunk.
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
