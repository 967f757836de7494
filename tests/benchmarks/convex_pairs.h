#pragma once

// Random pairs of convex polygons laid at a given separation, the same for every engine that is timed.

#include <vector>

#include "pair_sets.h"
#include "random_polygon.h"

namespace halfspace_benchmark {

/// Typical diameter, in m. Box2D wraps its polygons in a skin of 1 cm that its header does not allow to be
/// changed; at this size the skins of a pair are 2 % of the smallest gap below, so that both engines judge
/// the same geometry.
inline constexpr double size = 1000;

/// Position and turn of a polygon, rounded to float: both engines are given the same numbers.
struct Placement {
  Point position;
  double angle = 0;
};

/// Two polygons of a set, by index, and where they lie.
struct ConvexPair {
  int a = 0;
  int b = 0;
  Placement at_a;
  Placement at_b;
};

struct PairSet {
  std::vector<Points> polygons;  ///< counter-clockwise
  std::vector<ConvexPair> pairs;
};

/// Separation of two polygons: the largest, over all edges of both, of the least height of the other's
/// vertices over the edge. All edges against all vertices, in double.
double separation(const Points& a, const Points& b);

/// A pair's separation where it is laid.
double separation(const PairSet& set, const ConvexPair& pair);

/// Random polygons with `vertices` vertices each, and random pairs of them, all at the separation given and
/// with bounding boxes that overlap.
PairSet draw_pairs(int pair_count, int polygon_count, int vertices, const GapSet& gap, Random& random);

}  // namespace halfspace_benchmark
