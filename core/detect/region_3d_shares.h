#pragma once

#include "detect/contact.h"

namespace halfspace {

/// Shares the stiffness of a contact among the points of its region, and names the deepest one.
///
/// Level, each corner of a region has a share of its area so that the mean of a linear gap comes out exactly:
/// where a corner splits into two, they have its share between them. A point that rises from the deepest one
/// loses its share from a quarter to half the parallel angle on. So the force does not jump where the region
/// shrinks to a segment or a point, or grows out of one.
void share_stiffness(const DetectOptions& options, Contact<3>& contact);

/// The same of a contact at a point.
inline void share_at_point(Contact<3>& contact) {
  contact.deepest = 0;
  contact.shares[0] = 1;
  contact.share_rates[0] = 0;
}

}  // namespace halfspace
