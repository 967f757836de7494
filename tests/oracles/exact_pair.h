#pragma once

// The exact verdict on a pair of polygons: the theorem of separating axes in CGAL's exact ring Mpzf, on the
// doubles as they are.

#include <halfspace/halfspace.h>

#include "capi/handles.h"

namespace halfspace_test {

/// A polygon as the library was given it: vertices, the centroid it reported, a pose.
struct PlacedPolygon {
  const Points* vertices;  // counter-clockwise
  Point centroid;
  hs_pose pose;
};

struct ExactVerdict {
  bool touches;             // no edge has all of the other polygon strictly in front of it: exact
  long double largest_gap;  // over all edges of both; to `accuracy`
  long double accuracy;
  bool filter_was_enough;
};

/// The largest gap in long double, whose error bound decides the sign; where it does not, the edges in doubt
/// are evaluated exactly.
ExactVerdict exact_verdict(const PlacedPolygon& a, const PlacedPolygon& b);

/// Sign of the largest gap, all edges exactly, without the filter: 1 apart, 0 exactly touching, -1
/// overlapping.
int sign_of_largest_gap(const PlacedPolygon& a, const PlacedPolygon& b);

/// The gap of one edge, the least over the other's vertices, in long double.
long double gap_of_edge(const PlacedPolygon& owner, std::size_t edge, const PlacedPolygon& other);

/// Sum of both bounding radii and the distance of the centroids: the length that a gap's rounding is measured
/// by.
double extent(const PlacedPolygon& a, const PlacedPolygon& b);

/// Bound of the rounding in the library's gap, in units of 2^-53 * extent(). With u = 2^-53, for any
/// evaluation in double that starts from coordinates relative to the centroids:
///   local coordinates and the distance of the centroids, one subtraction each    1
///   a rotation from a quaternion, (w^2 - z^2)/(w^2 + z^2) and 2wz/(w^2 + z^2):
///     5 roundings per entry, 7 for the vector; composed with the other's 7, and 3
///     for the product of the two, then 3 to apply it                             20
///   an edge's normal: difference, length, quotient, 6 per component, 9 in all;
///     turned as well (10), it multiplies a vector no longer than the extent      19
///   two products and a sum in each of the three dot products, two sums           5
/// 45 in all; the next power-of-two-ish figure is used.
inline constexpr double rounding_bound = 48;

}  // namespace halfspace_test
