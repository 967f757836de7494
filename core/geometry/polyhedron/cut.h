#pragma once

#include "geometry/fault.h"
#include "geometry/polyhedron/polyhedron.h"

namespace halfspace {

/// The two parts of a convex polyhedron, each valid or empty.
struct PolyhedronParts {
  Polyhedron behind;
  Polyhedron ahead;
  /// The fault of a part that is too thin to be a polyhedron; then nothing is cut off, and the other part is
  /// the whole.
  Fault too_thin = Fault::none;
};

/// Cuts a valid polyhedron by the plane through `point` with normal `normal`, of any length. Both parts get
/// the same new vertices, and a new face as their last; all other faces keep the bits of their planes. A part
/// that the plane touches only to rounding is empty, and vertices a few ulps apart are merged. Heights of
/// vertices have the rounding error of their distance to `point`, which should not exceed the size of the
/// coordinates.
PolyhedronParts cut_polyhedron(const Polyhedron& whole, const Vector<3>& point, const Vector<3>& normal,
                               Memory* memory);

}  // namespace halfspace
