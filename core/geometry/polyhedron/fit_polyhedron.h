#pragma once

#include <cstdint>

#include "geometry/polyhedron/check.h"

namespace halfspace {

/// The changes made by fit_polyhedron() or, on a fault, the place of the largest dent.
struct FitReport {
  PolyhedronFault fault;    // with a dent, its vertex and its facet
  std::int64_t merged = 0;  // given facets minus faces made
  double deviation = 0;     // largest distance of a vertex from the plane of its face, or the largest dent
  double moved = 0;         // largest displacement of a corner
  double sufficient = 0;    // on Fault::beyond_tolerance: a sufficient tolerance; 0: none below the size
};

/// Makes a convex polyhedron of vertices and facets, or of points alone, that are convex only within a
/// tolerance, such as rounded coordinates of a file. Facets whose vertices are within the tolerance of a
/// common plane become one face, with a plane fitted by least squares. The polyhedron is the intersection of
/// their half-spaces: exactly convex, with plane faces. Each given vertex is within the tolerance of the
/// planes of its facets, and in front of none by more. A corner may move farther where planes meet at a small
/// angle. Rounding errors are always tolerated, and without any other merge no vertex moves. Points alone get
/// the facets of their hull. Loops may have either orientation, and a vertex may lie within an edge.
///
/// On a fault the polyhedron is empty.
FitReport fit_polyhedron(Polyhedron& polyhedron, double tolerance);

}  // namespace halfspace
