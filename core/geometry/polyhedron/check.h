#pragma once

#include <cstdint>
#include <span>

#include "geometry/fault.h"
#include "geometry/polyhedron/polyhedron.h"

namespace halfspace {

/// The first fault, and its vertex and face; -1 for the whole polyhedron.
struct PolyhedronFault {
  Fault fault = Fault::none;
  std::int64_t vertex = -1;
  std::int64_t face = -1;
};

/// Bound of a vertex's distance from the plane of its face by rounding, for coordinates up to `reach`.
/// Rotation, translation or interpolation has an error of about 4 eps * reach; 256 allow for dozens of them
/// in sequence.
double flatness_tolerance(double reach);

/// Vertices within this distance of a plane are on it: a few ulps of the vertex, and those of its height. Two
/// neighbouring faces are coplanar when all of their vertices are on both planes.
double coplanarity_tolerance(double reach);

/// Returns the reason why points have no hull: fewer than 4, out of range, coplanar.
PolyhedronFault check_points(std::span<const Vector<3>> points);

/// Returns the fault of vertices, loops and normals as a convex polyhedron without coplanar faces. Edges may
/// be short and angles small. Loops must be counter-clockwise.
PolyhedronFault check_polyhedron(const Polyhedron& polyhedron);

/// Computes the normals from vertices and loops, or returns their fault as a convex polyhedron without
/// coplanar faces. If all loops are clockwise, all are reversed.
PolyhedronFault complete_polyhedron(Polyhedron& polyhedron);

/// The same for the loops of an existing shape whose vertices have moved. A mirrored one has vertices outside
/// its faces.
PolyhedronFault complete_moved_polyhedron(Polyhedron& polyhedron);

}  // namespace halfspace
