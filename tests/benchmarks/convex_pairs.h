#pragma once

// Random pairs of convex polygons laid at a given separation, the same for every engine that is timed.

#include <random>
#include <vector>

#include "capi/handles.h"

namespace halfspace_benchmark {

using halfspace_test::Point;
using halfspace_test::Points;
using Random = std::mt19937_64;

/// Typical diameter, in m. Box2D wraps its polygons in a skin of 1 cm that its header does not allow to be changed; at this size
/// the skins of a pair are 2 % of the smallest gap below, so that both engines judge the same geometry.
inline constexpr double size = 1000;

struct GapSet {
  const char* name;
  double separation;  ///< share of the size; < 0 is overlap
};
inline constexpr GapSet gap_sets[] = {{"far", 0.1}, {"near", 1e-3}, {"touch", -1e-3}, {"deep", -0.2}};

/// Position and turn of a polygon, rounded to float: both engines are given the same numbers.
struct Placement {
  Point position;
  double angle = 0;
};

struct ConvexPair {
  Points a;
  Points b;
  Placement at_a;
  Placement at_b;
};

/// Separation of two polygons with vertices counter-clockwise: the largest, over all edges of both, of the least height of the
/// other's vertices over the edge. All edges against all vertices, in double.
double separation(const Points& a, const Points& b);

/// A pair's separation where it is laid.
double separation(const ConvexPair& pair);

/// Pairs with `vertices` vertices each, all at the set's separation, and with bounding boxes that overlap.
std::vector<ConvexPair> draw_pairs(int count, int vertices, const GapSet& set, Random& random);

}  // namespace halfspace_benchmark
