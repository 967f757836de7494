#pragma once

#include "geometry/polyhedron/check.h"

namespace halfspace {

/// Says what keeps loops of vertices from being one closed surface without holes, every edge of which two
/// faces share in opposite directions. Where the vertices are plays no part.
PolyhedronFault check_closed(const Polyhedron& polyhedron);

/// The same of a polyhedron's surface, each vertex of which is a corner of three faces at least.
PolyhedronFault check_surface(const Polyhedron& polyhedron);

}  // namespace halfspace
