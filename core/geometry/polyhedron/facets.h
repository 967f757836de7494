#pragma once

#include "geometry/polyhedron/polyhedron.h"

namespace halfspace {

/// Twice the area, along the normal: triangles from the first corner.
Vector<3> area_vector(const Polyhedron& polyhedron, std::int32_t face);

/// Turns all loops round when they run clockwise seen from outside. Requires a closed surface.
void turn_outward(Polyhedron& polyhedron);

}  // namespace halfspace
