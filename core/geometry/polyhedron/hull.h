#pragma once

#include <span>

#include "geometry/polyhedron/check.h"

namespace halfspace {

/// Convex hull: facets that qhull finds coplanar to coplanarity_tolerance() become one face. Its vertices are
/// points, in their order. On a fault the hull is empty: zero_volume when all points are coplanar to
/// rounding, out_of_range with the point, hull_failed or a fault of the hull when the points are so nearly
/// degenerate that qhull or the check of its result fails. Throws bad_alloc also when malloc, which qhull
/// uses, fails.
PolyhedronFault convex_hull(std::span<const Vector<3>> points, Polyhedron& hull);

}  // namespace halfspace
