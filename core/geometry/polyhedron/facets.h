#pragma once

#include "geometry/polyhedron/polyhedron.h"

namespace halfspace {

/// The area times two, along the normal, by triangles from the first corner.
Vector<3> area_vector(const Polyhedron& polyhedron, std::int32_t face);

/// Reverses all loops if they are clockwise seen from outside. Requires a closed surface.
void turn_outward(Polyhedron& polyhedron);

}  // namespace halfspace
