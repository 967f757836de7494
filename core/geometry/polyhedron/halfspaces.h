#pragma once

#include <cstdint>
#include <span>

#include "geometry/polyhedron/check.h"
#include "geometry/polyhedron/interior.h"

namespace halfspace {

/// The intersection of half-spaces: one face per half-space that bounds it, with that half-space's normal.
/// Half-spaces that cut off only rounding errors are redundant; their number is returned. By duality:
/// relative to the point farthest inside, half-spaces are points, whose hull has a vertex per face and a face
/// per vertex. Half-spaces that the dual hull merges, but that cut something off, are applied last.
///
/// On a fault the polyhedron is empty: out_of_range or no_direction with the half-space in `face`, unbounded,
/// no_common_point, or a fault of the hull.
PolyhedronFault polyhedron_from_halfspaces(std::span<const Halfspace<3>> halfspaces, Polyhedron& polyhedron,
                                           std::int64_t& redundant);

}  // namespace halfspace
