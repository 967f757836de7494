#pragma once

#include "geometry/outline.h"

namespace halfspace {

/// A vertex of a polyhedron, and its height along a direction.
struct Support {
  double height;
  int vertex;
};

/// Up to this many vertices, testing all is the fastest search without a nearby start (tests/benchmarks,
/// bench_pairs_3d).
constexpr int few_vertices = 128;

/// The deepest vertex along a direction of a block with many vertices: walks over its edges from a nearby
/// vertex, or from the deepest of a sample.
Support walk_to_deepest(const Outline<3>& block, const Vector<3>& direction, int hint);
Support walk_to_deepest(const Outline<3>& block, const Vector<3>& direction);

}  // namespace halfspace
