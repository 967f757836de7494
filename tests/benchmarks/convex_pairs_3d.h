#pragma once

// Random pairs of convex polyhedra laid at a given separation, the same for every engine that is timed.

#include "benchmarks/peers_3d.h"

namespace halfspace_benchmark {

/// Typical diameter. The tolerances of the peers are absolute and made for things of this size.
inline constexpr double size_3d = 1;

struct GapSet3 {
  const char* name;
  double separation;  ///< share of the size; < 0 is overlap
};
inline constexpr GapSet3 gap_sets_3d[] = {{"far", 0.1}, {"near", 1e-3}, {"touch", -1e-3}, {"deep", -0.2}};

/// Random polyhedra with `vertices` vertices each, boxes if 8, and random pairs of them, all at the
/// separation given and with bounding boxes that overlap. The separation is the largest gap of all facets of
/// the Minkowski difference.
PairSet3 draw_pairs_3d(int pair_count, int polyhedron_count, int vertices, const GapSet3& gap,
                       Random& random);

}  // namespace halfspace_benchmark
