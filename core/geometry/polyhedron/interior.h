#pragma once

#include <span>

#include "geometry/halfspace.h"
#include "geometry/vector.h"

namespace halfspace {

/// A point and its smallest distance to the planes, negative when it is outside one.
struct Interior {
  Vector<3> point;
  double clearance;
};

/// The Chebyshev centre of half-spaces with unit normals: the point farthest from all planes. It is limited
/// to a tetrahedron of a million times the largest offset, so that it exists for unbounded intersections,
/// too. A clearance <= 0, or below the rounding of the point, means that no point is inside all half-spaces
/// and the tetrahedron.
Interior farthest_inside(std::span<const Halfspace<3>> halfspaces, Memory* memory);

}  // namespace halfspace
