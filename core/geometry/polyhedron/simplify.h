#pragma once

#include "geometry/polyhedron/polyhedron.h"

namespace halfspace {

/// Removes vertices with fewer than three faces, faces with fewer than three vertices, and unused vertices.
/// Each edge still has two faces. No vertex moves.
void drop_degenerate(Polyhedron& polyhedron);

/// Merges the ends of every edge whose components are all within `length`, and removes what becomes
/// degenerate.
void weld_short_edges(Polyhedron& polyhedron, double length);

}  // namespace halfspace
