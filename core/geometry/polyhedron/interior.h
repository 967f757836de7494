#pragma once

#include <span>

#include "geometry/halfspace.h"
#include "geometry/vector.h"

namespace halfspace {

/// A point and its least distance to the planes, negative when it is outside one.
struct Interior {
  Vector<3> point;
  double clearance;
};

/// The point farthest from all planes (the centre of the largest sphere between them) of half-spaces with
/// unit normals. The sphere is kept within a tetrahedron a million times the largest offset, so that there is
/// one when the half-spaces are unbounded, too. A clearance <= 0, or hidden by the rounding of the point,
/// means that the half-spaces have no common point inside them all, or none within that tetrahedron.
Interior farthest_inside(std::span<const Halfspace<3>> halfspaces, Memory* memory);

}  // namespace halfspace
