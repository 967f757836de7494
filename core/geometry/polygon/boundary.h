#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// A segment of a chain that bounds a region on its left, with the points before and after it.
struct BoundarySegment {
  Vector<2> before;
  Vector<2> first;
  Vector<2> second;
  Vector<2> after;
};

/// The virtual polygon of a boundary segment (Zheng et al. 2020, section 3.3), counter-clockwise. It extends
/// `depth` behind the segment, and beyond its ends by depth / tan(60).
///
/// From each end a flank goes under the neighbouring segment, at 60 degrees to it. So where two segments are
/// in line, the distances to the nearest edges of both polygons add up to the depth below one long segment: a
/// point at depth d and distance x from the joint is d cos(60) - x sin(60) inside one and d cos(60) + x
/// sin(60) inside the other, until it is outside the first and the segment is the nearest edge of the second.
/// At a concave corner above 60 degrees the segment itself is extended behind its neighbour, and at a sharper
/// convex corner both polygons meet in the bisector. So there are neither overhangs nor gaps.
///
/// Fewer than 3 vertices are returned when the polygon vanishes in rounding.
Array<Vector<2>> polygon_behind(const BoundarySegment& segment, double depth, Memory* memory);

}  // namespace halfspace
