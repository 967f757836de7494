#pragma once

#include "detect/contact.h"
#include "geometry/outline.h"

namespace halfspace {

/// The part of a block that lies behind the contact plane, over the edge that is the plane.
struct Overlap {
  double area = 0;  // integral of the depth
  double depth_squared =
      0;             // integral of the square of the depth over the edge: twice the energy per unit stiffness
  double width = 0;  // along the edge
  Vector<2> center{0, 0};  // centroid, moved onto the contact plane; relative to the centroid of a
};

/// Exact overlap at a contact: the linear depth between the contact plane and the other block's outline,
/// integrated over the edge. Cost grows with the number of vertices behind the plane.
Overlap measure_overlap(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                        const PotentialPair<2>& pair);

}  // namespace halfspace
