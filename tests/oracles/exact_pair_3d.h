#pragma once

// The exact verdict on a pair of polyhedra: the theorem of separating axes in CGAL's exact ring Mpzf, on the
// doubles as they are. A pose is taken at its word: the turn of its quaternion q, brought to unit length, is
// rational in q, and nothing is rounded.

#include "oracles/minkowski_facets.h"

namespace halfspace_test {

struct ExactVerdict3 {
  bool touches;   // no facet has all of b strictly in front of it: exact
  double gap;     // the largest of all facets, to `accuracy`
  Point3 normal;  // of the facet with that gap, in the frame of a
  double accuracy;
  bool filter_was_enough;
};

/// The gaps in double, whose error bounds decide the sign; where they do not, the facets in doubt are
/// evaluated exactly.
/// @param facets of a and b as they are turned
ExactVerdict3 exact_verdict(const PlacedPolyhedron& a, const PlacedPolyhedron& b,
                            const MinkowskiFacets& facets);

/// The verdict by CGAL's exact linear programming: is there a point that both hulls have? Shares nothing with
/// the facets.
bool have_a_common_point(const PlacedPolyhedron& a, const PlacedPolyhedron& b);

/// Sum of both bounding radii and the distance of the centres: the length that a gap's rounding is measured
/// by.
double extent(const MinkowskiFacets& facets, const Point3& apart);

}  // namespace halfspace_test
