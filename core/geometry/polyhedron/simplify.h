#pragma once

#include "geometry/polyhedron/polyhedron.h"

namespace halfspace {

/// Drops vertices with fewer than three faces, faces with fewer than three vertices, and vertices without
/// use. Edges stay shared by two faces. No vertex moves.
void drop_degenerate(Polyhedron& polyhedron);

/// Makes one vertex of the two ends of every edge whose components are all within `length`, and drops what
/// that leaves degenerate.
void weld_short_edges(Polyhedron& polyhedron, double length);

}  // namespace halfspace
