#pragma once

#include <cstdint>

#include "geometry/polyhedron/check.h"

namespace halfspace {

/// The changes that fit_polyhedron() made or, on a fault, the place of the largest dent.
struct FitReport {
  PolyhedronFault fault;    // with a dent, its vertex and its facet
  std::int64_t merged = 0;  // facets given beyond the faces made
  double deviation = 0;     // largest distance of a vertex from the plane of its face, or the largest dent
  double moved = 0;         // largest distance of a corner from where it was given
  double sufficient = 0;    // on Fault::beyond_tolerance: a tolerance that would do; 0: none below the size
};

/// Makes a convex polyhedron of vertices and facets, or of points alone, that are so within a tolerance, such
/// as those of a file that states a few digits. Facets whose vertices lie within the tolerance of a common
/// plane are one face, their planes are fitted by least squares, and the polyhedron is what their half-spaces
/// have in common: exactly convex, with plane faces. Each vertex given lies within the tolerance of the
/// planes of its facets, and outside none by more. A corner may have moved farther where planes meet at a
/// small angle. Rounding counts as tolerance, and where nothing but rounding has to be merged no vertex
/// moves. Points alone have the facets of their hull. Loops may run either way, and a vertex may lie within
/// an edge.
///
/// On a fault the polyhedron is empty.
FitReport fit_polyhedron(Polyhedron& polyhedron, double tolerance);

}  // namespace halfspace
