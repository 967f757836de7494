#pragma once

#include "narrow_phase/contact.h"
#include "narrow_phase/space/minkowski_difference.h"

namespace halfspace {

/// The potential pair of minimum depth of overlapping blocks, or a plane between separated blocks, without
/// testing all pairs, whose number is the product of both blocks' features. GJK moves a simplex of corners of
/// the Minkowski difference towards the origin until it contains it or a plane separates them (Gilbert,
/// Johnson and Keerthi 1988); then EPA expands a polytope to the nearest facet.
template <class Turn>
Separation<3> find_separation_by_descent(const MinkowskiDifference<Turn>& difference);

}  // namespace halfspace
