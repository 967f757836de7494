#pragma once

// What is true of two polygons as posed, and what a manifold states of them, in long double and apart from
// both engines.

#include <box2d/box2d.h>

#include <vector>

#include "capi/handles.h"

namespace halfspace_test {

struct Direction {
  long double x, y;
};

/// A face of either polygon and its gap: the least height of the other's vertices over it.
struct FaceGap {
  int owner;  // 0 a, 1 b
  int edge;
  long double gap;
  long double beyond;  // how far the other's least high vertex is past the face's ends, below 0 between them
  Direction normal;    // from a to b, of unit length
};

/// All faces, of a first. Vertices are counter-clockwise, in the coordinates of their bodies, and turned by
/// the floats of the transforms after these have been brought to unit length.
std::vector<FaceGap> face_gaps(const Points& a, const b2Transform& at_a, const Points& b,
                               const b2Transform& at_b);

/// The one of largest gap.
FaceGap largest(const std::vector<FaceGap>& gaps);

/// The floats of a shape.
Points vertices_of(const b2PolygonShape& shape);

/// What a manifold that has points says by its own numbers: its normal from a to b, and the least height of
/// its points over its face.
struct StatedContact {
  long double gap;
  Direction normal;
};
StatedContact stated_by(const b2Manifold& manifold, const b2Transform& at_a, const b2Transform& at_b);

}  // namespace halfspace_test
