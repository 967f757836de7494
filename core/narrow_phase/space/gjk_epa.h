#pragma once

#include "narrow_phase/contact.h"
#include "narrow_phase/space/minkowski_difference.h"

namespace halfspace {

/// The potential pair of least depth of blocks that overlap, or a plane between blocks that are apart, found
/// by descent instead of by judging all pairs, whose number grows with the product of both blocks' features.
/// First a simplex of corners of the Minkowski difference is moved towards the origin until it holds it or is
/// found behind a plane (Gilbert, Johnson and Keerthi 1988); from there a polytope expands to the nearest
/// facet.
template <class Turn>
Separation<3> find_separation_by_descent(const MinkowskiDifference<Turn>& difference);

}  // namespace halfspace
