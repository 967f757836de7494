#pragma once

#include "geometry/polyhedron/fit_plane.h"
#include "geometry/polyhedron/polyhedron.h"

namespace halfspace {

/// Facets of a surface sorted into faces, each with the plane fitted to all of its vertices.
struct MergedFacets {
  explicit MergedFacets(Memory* memory) : face_of_facet(memory), planes(memory) {}

  Array<std::int32_t> face_of_facet;
  Array<FittedPlane> planes;
};

/// Merges neighbouring facets as long as all of their vertices lie within the tolerance of a common fitted
/// plane. Faces grow from the largest facets on, so that narrow ones, whose own direction is that of the
/// rounding of their corners, come to the face that they lie in. A single facet may deviate by more than the
/// tolerance; one without an area has a deviation that is infinite. Requires a closed surface whose loops run
/// counter-clockwise.
MergedFacets merge_facets(const Polyhedron& surface, double tolerance);

}  // namespace halfspace
