#pragma once

#include <span>

#include "geometry/polyhedron/check.h"

namespace halfspace {

/// Convex hull with whole faces: facets that qhull finds in one plane to coplanarity_tolerance() are one
/// face. Its vertices are points, in their order. On a fault the hull is empty: zero_volume when all points
/// are in one plane to rounding, out_of_range with the point, hull_failed or the fault of the hull when the
/// points lie so close to degenerate that qhull, or the check of what it found, gives up. Bad_alloc also when
/// qhull, which takes its own memory from malloc, gets none.
PolyhedronFault convex_hull(std::span<const Vector<3>> points, Polyhedron& hull);

}  // namespace halfspace
