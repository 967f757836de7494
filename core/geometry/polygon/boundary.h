#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// A segment of a chain that bounds a region at its left, and where the chain comes from and goes on to.
struct BoundarySegment {
  Vector<2> before;
  Vector<2> first;
  Vector<2> second;
  Vector<2> after;
};

/// The virtual polygon of which a boundary segment is an edge (Zheng et al. 2020, section 3.3),
/// counter-clockwise. It reaches `depth` behind the segment, and beyond its ends by depth / tan(60).
///
/// From either end a flank goes under the neighbouring segment, 60 degrees steep to that one. So at a joint
/// in line the distances to the nearest edge of either polygon add up to the depth below one long segment: a
/// point at depth d and a distance x from the joint is d cos(60) - x sin(60) inside the one and d cos(60) + x
/// sin(60) inside the other, until the former is outside and the segment is as near to the latter. Where a
/// hollow bends by more than 60 degrees the segment itself reaches on behind its neighbour, and at a sharper
/// ridge both polygons meet in the bisector. So nothing stands out, and no gap is left.
///
/// A polygon that rounding hides has fewer than 3 vertices.
Array<Vector<2>> polygon_behind(const BoundarySegment& segment, double depth, Memory* memory);

}  // namespace halfspace
