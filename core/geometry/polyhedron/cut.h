#pragma once

#include "geometry/fault.h"
#include "geometry/polyhedron/polyhedron.h"

namespace halfspace {

/// The two parts of a convex polyhedron, each valid or empty.
struct PolyhedronParts {
  Polyhedron behind;
  Polyhedron ahead;
  /// The fault that a part cut off would have, when it is too thin to be a polyhedron; then there is no cut,
  /// and the other part is the whole.
  Fault too_thin = Fault::none;
};

/// Cuts a valid polyhedron by the plane through `point` with normal `normal`, which need not be of unit
/// length. Both parts get the same new vertices and a new face each, the last; all other faces keep their
/// planes, to the bit. A part that the plane touches only to rounding is empty, and vertices a few roundings
/// apart become one. The heights of vertices carry the rounding of their distance to `point`, which should
/// therefore be as near as the coordinates are large, or nearer.
PolyhedronParts cut_polyhedron(const Polyhedron& whole, const Vector<3>& point, const Vector<3>& normal,
                               Memory* memory);

}  // namespace halfspace
