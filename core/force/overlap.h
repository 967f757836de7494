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

/// The same in space, over a face. Between two edges: the depth between the planes of the faces at both, over
/// the quadrilateral that they have in common. Cost grows with the number of faces.
Overlap<3> measure_overlap(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                           const PotentialPair<3>& pair);

}  // namespace halfspace
