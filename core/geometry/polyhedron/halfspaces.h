#pragma once

#include <cstdint>
#include <span>

#include "geometry/polyhedron/check.h"
#include "geometry/polyhedron/interior.h"

namespace halfspace {

/// The polyhedron that half-spaces have in common: one face per half-space that bounds it, with the
/// half-space's own normal. Half-spaces that cut off nothing but rounding are redundant; how many there are
/// is given. By duality: seen from the point farthest inside, half-spaces are points, whose hull has a vertex
/// for each face wanted and a face for each vertex. Half-spaces that the dual hull does not tell apart, and
/// that do cut something off, are cut by last.
///
/// On a fault the polyhedron is empty: out_of_range or no_direction with the half-space in `face`, unbounded,
/// no_common_point, or a fault of the hull.
PolyhedronFault polyhedron_from_halfspaces(std::span<const Halfspace<3>> halfspaces, Polyhedron& polyhedron,
                                           std::int64_t& redundant);

}  // namespace halfspace
