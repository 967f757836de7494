#pragma once

#include <cstdint>
#include <span>

#include "geometry/fault.h"
#include "geometry/polyhedron/polyhedron.h"

namespace halfspace {

/// The first fault, and the vertex and face it sits at, -1 when it is the whole polyhedron.
struct PolyhedronFault {
  Fault fault = Fault::none;
  std::int64_t vertex = -1;
  std::int64_t face = -1;
};

/// How far rounding may put a vertex off the plane of its face, for coordinates up to `reach`. A vertex that
/// is turned, moved or interpolated between two others is off by some 4 units of rounding, eps * reach; 256
/// leave room for dozens of such steps one after the other.
double flatness_tolerance(double reach);

/// Within this a vertex cannot be told from one on a plane: a few units of rounding of the vertex, and those
/// of its height. Two neighbouring faces whose vertices are all that near to both planes are one face.
double coplanarity_tolerance(double reach);

/// Says what keeps points from having a hull at all: fewer than 4, out of range, all in one plane.
PolyhedronFault check_points(std::span<const Vector<3>> points);

/// Says what keeps vertices, loops and normals from being a convex polyhedron with whole faces. Edges may be
/// short and angles small. Loops run counter-clockwise.
PolyhedronFault check_polyhedron(const Polyhedron& polyhedron);

/// Gives vertices and loops alone the normals that they imply, or says what keeps them from being a convex
/// polyhedron with whole faces. When all loops run clockwise, all are turned round.
PolyhedronFault complete_polyhedron(Polyhedron& polyhedron);

}  // namespace halfspace
