#pragma once

#include "geometry/outline.h"
#include "narrow_phase/contact.h"

namespace halfspace {

// Independent springs at the corners of a contact's region (Wang et al. 2021, eq. 36).
//
// The stiffness is distributed evenly over the directions in the contact plane. A corner has the stiffness of
// the directions in which it is the outermost: its exterior angle divided by 2 pi. In 2D there are two
// directions, and two springs of half the stiffness. A corner that splits into two distributes its stiffness
// to them, and a region that shrinks to a segment leaves half at each end, so that the force is continuous.
// The angle at a vertex is that of its face, for any tilt: so no stiffness moves with the tilt, and no couple
// results (docs/decisions/springs_at_corners.md).

/// The fractions of a contact's stiffness at its points. Those of a region of faces add up to 1.
template <int D>
struct PointSprings {
  double part[D == 2 ? 2 : max_region_points];
};

inline PointSprings<2> point_springs(const Outline<2>&, const Outline<2>&, const Vector<2>&,
                                     const Contact<2>&) {
  return {{0.5, 0.5}};
}
/// A vertex or an edge alone has the springs that it would have in a region of its face most nearly parallel
/// to the contact plane. Crossing edges count as orthogonal.
PointSprings<3> point_springs(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                              const Contact<3>& contact);

/// Length or area of a contact's region.
inline double base_of(const Contact<2>& contact) { return contact.length; }
inline double base_of(const Contact<3>& contact) { return contact.area; }

/// The part of a contact's region in which the blocks overlap, or all of it where they are bonded: there
/// shear acts.
struct LoadedPart {
  Vector<3> middle;
  double mean_distance;  // of its points from the middle
};
LoadedPart loaded_part(const Contact<3>& contact, bool bonded);

}  // namespace halfspace
