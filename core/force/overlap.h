#pragma once

#include "detect/contact.h"
#include "geometry/outline.h"

namespace halfspace {

/// The part of a block that lies behind the contact plane, over the edge or face that is the plane.
template <int D>
struct Overlap {
  double content = 0;        // area or volume: integral of the depth over the edge or face
  double depth_squared = 0;  // integral of the square of the depth: twice the energy per unit stiffness
  double base = 0;           // length or area on the contact plane
  Vector<D> center =
      Vector<D>::Zero();    // centroid, moved onto the contact plane; relative to the centroid of a
  double twist_radius = 0;  // in space: radius of gyration of the depth about the normal through the centroid
};

/// Exact overlap at a contact: the linear depth between the contact plane and the other block's outline,
/// integrated over the edge. Cost grows with the number of vertices behind the plane.
Overlap<2> measure_overlap(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                           const PotentialPair<2>& pair);

/// What two blocks have in common, seen along a contact's normal: the depth is that from the one's surface to
/// the other's, so that the content is the volume of their intersection. The centre lies on the contact
/// plane, which goes through `point`. Cost grows with the number of faces, and with the product of those that
/// reach behind the other block's foremost point.
Overlap<3> measure_overlap(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                           const Vector<3>& normal, const Vector<3>& point);

/// The overlap that a contact's force follows from.
inline Overlap<2> overlap_of(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                             const Contact<2>& contact) {
  return measure_overlap(a, b, to_b, contact.pair);
}
inline Overlap<3> overlap_of(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                             const Contact<3>& contact) {
  return measure_overlap(a, b, to_b, contact.normal, contact.center);
}

}  // namespace halfspace
