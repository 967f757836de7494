#pragma once

// Polygons in CGAL's exact kernel. Its Boolean set operations are independent of everything else here.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>

#include "oracles/exact_pair.h"

namespace halfspace_test {

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactNumber = ExactKernel::FT;
using ExactPolygon = CGAL::Polygon_2<ExactKernel>;

ExactPolygon exact_polygon(const Points& vertices);

/// Turned and moved as its pose says, exactly: the rotation matrix of a quaternion is rational in it.
ExactPolygon placed_exactly(const PlacedPolygon& polygon);

/// Do the interiors overlap?
bool interiors_overlap(const ExactPolygon& a, const ExactPolygon& b);

/// The part of a convex polygon where dot(normal, p - point) <= 0.
ExactPolygon part_behind(const ExactPolygon& polygon, Point point, Point normal);

/// Area, centroid and second moments about the centroid.
struct ExactMoments {
  ExactNumber area;
  ExactNumber centroid[2];
  ExactNumber second_moment[3];  // xx, yy, xy
};
ExactMoments exact_moments(const ExactPolygon& polygon);

inline double rounded(const ExactNumber& x) { return CGAL::to_double(x.exact()); }

}  // namespace halfspace_test
