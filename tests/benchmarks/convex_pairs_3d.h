#pragma once

// Random pairs of convex polyhedra laid at a given separation, the same for every engine that is timed.

#include "benchmarks/pair_sets.h"
#include "benchmarks/peers_3d.h"

namespace halfspace_benchmark {

/// Typical diameter. The tolerances of the peers are absolute and made for things of this size.
inline constexpr double size_3d = 1;

/// Random polyhedra with `vertices` vertices each, boxes if 8, and random pairs of them, all at the
/// separation given and with bounding boxes that overlap. The separation is the largest gap of all facets of
/// the Minkowski difference.
PairSet3 draw_pairs_3d(int pair_count, int polyhedron_count, int vertices, const GapSet& gap, Random& random);

}  // namespace halfspace_benchmark
