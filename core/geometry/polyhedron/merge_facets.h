#pragma once

#include "geometry/polyhedron/fit_plane.h"
#include "geometry/polyhedron/polyhedron.h"

namespace halfspace {

/// Facets of a surface grouped into faces, each with the plane fitted to all of its vertices.
struct MergedFacets {
  explicit MergedFacets(Memory* memory) : face_of_facet(memory), planes(memory) {}

  Array<std::int32_t> face_of_facet;
  Array<FittedPlane> planes;
};

/// Merges neighbouring facets while all of their vertices are within the tolerance of a common fitted plane.
/// Faces grow from the largest facets, so that narrow ones, whose normals are dominated by rounding, join the
/// face in which they lie. A single facet may deviate by more than the tolerance; one without area has an
/// infinite deviation. Requires a closed surface with counter-clockwise loops.
MergedFacets merge_facets(const Polyhedron& surface, double tolerance);

/// The surface with the outlines of its faces in place of facets, and no vertex that has fewer than three
/// faces. A face with a hole, of which one outline is taken, leaves a surface that is not closed.
Polyhedron outlines_of(const Polyhedron& surface, const MergedFacets& faces);

}  // namespace halfspace
