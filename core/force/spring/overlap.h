#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/convex_reach.h"
#include "geometry/outline.h"
#include "narrow_phase/contact.h"

namespace halfspace {

/// The common part of two blocks, as it lies behind the contact plane.
template <int D>
struct Overlap {
  double content = 0;        // area or volume: integral of the depth over the base
  double depth_squared = 0;  // integral of the square of the depth: twice the energy per unit stiffness
  double base = 0;           // length or area on the contact plane
  Vector<D> center =
      Vector<D>::Zero();    // centroid, moved onto the contact plane; relative to the centroid of a
  double twist_radius = 0;  // in space: radius of gyration of the depth about the normal through the centroid
  Vector<D> middle = Vector<D>::Zero();  // centroid of the base
  Tensor<D> spread = Tensor<D>::Zero();  // mean over the base of the way from there times itself^T

  /// How far the depth's centroid is from the middle of the base at most, as a share of what is certain to
  /// belong to the base. An even depth has none; in the plane one that falls to nothing at the other end has
  /// 1/3. An overlap of nothing but rounding has 1 at most.
  double unevenness() const {
    const double mean_square = depth_squared * base / (content * content);
    return mean_square > 1 ? std::min(std::sqrt(mean_square - 1) / certain_reach(D - 1), 1.0) : 0;
  }
};

/// Measures the common part of two blocks along a contact's unit normal from a to b: the depth is that from
/// the one's surface to the other's, so that the content is the area or volume of their intersection. In the
/// plane the outlines are looked at between the contact plane and the deepest vertex only.
Overlap<2> measure_overlap(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                           const PotentialPair<2>& pair, const Vector<2>& normal);

/// In space the contact plane goes through `point`, and the centre lies on it. Cost grows with the number of
/// faces, and with the product of those that reach behind the other block's foremost point.
Overlap<3> measure_overlap(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                           const Vector<3>& normal, const Vector<3>& point);

/// The overlap that a contact's force follows from.
inline Overlap<2> overlap_of(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                             const Contact<2>& contact) {
  return measure_overlap(a, b, to_b, contact.pair, contact.normal);
}
inline Overlap<3> overlap_of(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                             const Contact<3>& contact) {
  return measure_overlap(a, b, to_b, contact.normal, contact.center);
}

}  // namespace halfspace
