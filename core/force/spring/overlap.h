#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/convex_reach.h"
#include "geometry/outline.h"
#include "narrow_phase/contact.h"

namespace halfspace {

/// The overlap of two blocks, measured from the contact plane.
template <int D>
struct Overlap {
  double content = 0;        // area or volume: integral of the depth over the base
  double depth_squared = 0;  // integral of the squared depth: twice the energy per unit stiffness
  double base = 0;           // length or area on the contact plane
  Vector<D> center =
      Vector<D>::Zero();    // centroid, projected onto the contact plane; relative to the centroid of a
  double twist_radius = 0;  // in 3D: radius of gyration of the depth about the normal through the centroid
  Vector<D> middle = Vector<D>::Zero();  // centroid of the base
  Tensor<D> spread = Tensor<D>::Zero();  // mean over the base of r r^T about its centroid

  /// Bound of the distance between the centroids of depth and base, divided by the certain extent of the
  /// base; at most 1. It is 0 for a constant depth; in 2D 1/3 for one that is 0 at one end.
  double unevenness() const {
    const double mean_square = depth_squared * base / (content * content);
    return mean_square > 1 ? std::min(std::sqrt(mean_square - 1) / certain_reach(D - 1), 1.0) : 0;
  }
};

/// Measures the overlap of two blocks along a contact's unit normal from a to b: the depth is measured
/// between both surfaces, so that the content is the area or volume of the intersection. In 2D only the part
/// of the outlines between the contact plane and the deepest vertex is used.
Overlap<2> measure_overlap(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                           const PotentialPair<2>& pair, const Vector<2>& normal);

/// In 3D the contact plane goes through `point`, and the centre lies on it. The cost grows with the number of
/// faces, and with the product of those that extend behind the other block's foremost point.
Overlap<3> measure_overlap(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                           const Vector<3>& normal, const Vector<3>& point);

/// The overlap for a contact's force.
inline Overlap<2> overlap_of(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                             const Contact<2>& contact) {
  return measure_overlap(a, b, to_b, contact.pair, contact.normal);
}
inline Overlap<3> overlap_of(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                             const Contact<3>& contact) {
  return measure_overlap(a, b, to_b, contact.normal, contact.center);
}

}  // namespace halfspace
