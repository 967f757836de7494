#pragma once

#include "geometry/polyhedron/check.h"

namespace halfspace {

/// Returns the fault of loops as one closed surface without holes, where each edge has two faces in opposite
/// directions. Independent of coordinates.
PolyhedronFault check_closed(const Polyhedron& polyhedron);

/// The same for a polyhedron, where each vertex has at least three faces.
PolyhedronFault check_surface(const Polyhedron& polyhedron);

}  // namespace halfspace
