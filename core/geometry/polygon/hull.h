#pragma once

#include <span>

#include "geometry/vector.h"

namespace halfspace {

/// Convex hull, counter-clockwise, without vertices that are on the line of their neighbours to rounding.
/// Returns fewer than 3 vertices when all points are on one line.
Array<Vector<2>> convex_hull(std::span<const Vector<2>> points, Memory* memory);

}  // namespace halfspace
