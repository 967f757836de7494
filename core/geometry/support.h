#pragma once

#include "geometry/outline.h"

namespace halfspace {

/// A vertex of a polyhedron and how far it lies along some direction.
struct Support {
  double height;
  int vertex;
};

/// Up to this many vertices, to look at all for the deepest is faster than anything else that knows no vertex
/// near it (tests/benchmarks, bench_pairs_3d).
constexpr int few_vertices = 128;

/// The vertex of a block of many that lies deepest along a direction, by a walk over its edges from a vertex
/// near it; or from the deepest of some that are spread over the block.
Support walk_to_deepest(const Outline<3>& block, const Vector<3>& direction, int hint);
Support walk_to_deepest(const Outline<3>& block, const Vector<3>& direction);

}  // namespace halfspace
