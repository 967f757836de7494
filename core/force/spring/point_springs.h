#pragma once

#include "geometry/outline.h"
#include "narrow_phase/contact.h"

namespace halfspace {

// Springs at the corners of a contact's region, each on its own (Wang et al. 2021, eq. 36).
//
// The stiffness is shared evenly among the directions in the contact plane, and a corner has that of all
// directions in which it is the outermost: its exterior angle over a whole turn. In the plane there are two
// directions, and two springs of half the stiffness. A corner that splits into two leaves them what it had,
// and a region that shrinks to a segment leaves each end a half, so that nothing jumps where a region
// changes. The angle at a vertex is that of its face, however the block is tilted: so no stiffness moves as
// the tilt changes, and no couple comes of it (docs/decisions/springs_at_corners.md).

/// The parts of a contact's stiffness that its points have. Those of a region of faces add up to 1.
template <int D>
struct PointSprings {
  double part[D == 2 ? 2 : max_region_points];
};

inline PointSprings<2> point_springs(const Outline<2>&, const Outline<2>&, const Vector<2>&,
                                     const Contact<2>&) {
  return {{0.5, 0.5}};
}
/// A vertex or an edge that touches alone has the springs that it would have in a region of the face at it
/// that looks most against the contact plane. Edges that cross count as square to each other.
PointSprings<3> point_springs(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                              const Contact<3>& contact);

/// Length or area of a contact's region.
inline double base_of(const Contact<2>& contact) { return contact.length; }
inline double base_of(const Contact<3>& contact) { return contact.area; }

/// Radius of gyration of the springs' forces about the normal through their centre. A share of force each,
/// all of them together 1.
inline double twist_radius(const Contact<2>&, const Vector<2>&, const double*) { return 0; }
double twist_radius(const Contact<3>& contact, const Vector<3>& center, const double* share);

}  // namespace halfspace
