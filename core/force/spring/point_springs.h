#pragma once

#include "narrow_phase/contact.h"

namespace halfspace {

// One spring at each point of a contact's region, the contact's stiffness shared among them (Wang et al.
// 2021, eq. 36).

/// Length or area of a contact's region.
inline double base_of(const Contact<2>& contact) { return contact.length; }
inline double base_of(const Contact<3>& contact) { return contact.area; }

/// Moment on b, for unit stiffness, of the energy that moves from spring to spring as the blocks turn against
/// each other and the shares of the stiffness change: the energy differentiated by that turn. Depths are 0
/// where a spring does not act.
inline Angular<2> couple_of_shares(const Contact<2>& contact, const double* depth) {
  if (contact.point_count == 1) return Angular<2>::Zero();
  return Angular<2>(-0.5 * contact.share_rate * (depth[0] * depth[0] - depth[1] * depth[1]));
}
Angular<3> couple_of_shares(const Contact<3>& contact, const double* depth);

/// How much stiffer, for unit stiffness, the shares make a contact against turning than springs at its points
/// would be: a bound on that energy differentiated twice, wherever in the transition the blocks are.
double turning_stiffness_of_shares(const Contact<2>& contact, double parallel_angle);
double turning_stiffness_of_shares(const Contact<3>& contact, double parallel_angle);

/// Radius of gyration of the springs' forces about the normal through their centre. A share of force each,
/// all of them together 1.
inline double twist_radius(const Contact<2>&, const Vector<2>&, const double*) { return 0; }
double twist_radius(const Contact<3>& contact, const Vector<3>& center, const double* share);

}  // namespace halfspace
