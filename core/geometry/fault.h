#pragma once

#include <cstdint>

namespace halfspace {

/// Faults of a polygon or polyhedron. The values are those of the C API.
enum class Fault : std::int32_t {
  none = 0,
  // A polygon's vertices.
  too_few_vertices = 1,
  not_finite = 2,
  repeated_vertex = 3,
  collinear_vertex = 4,
  not_convex = 5,
  self_crossing = 6,
  zero_area = 7,
  // Topology of a polyhedron.
  fewer_than_four = 8,
  face_too_short = 9,
  no_such_vertex = 10,
  vertex_twice_in_face = 11,
  unused_vertex = 12,
  unmatched_edge = 13,
  vertex_inside_edge = 14,
  not_one_surface = 15,
  // Geometry of a polyhedron.
  out_of_range = 16,
  coinciding_vertices = 17,
  zero_volume = 18,
  face_without_area = 19,
  face_not_plane = 20,
  vertex_outside_face = 21,
  coplanar_faces = 22,
  // Points or half-spaces that have no polyhedron.
  hull_failed = 23,
  no_direction = 24,
  unbounded = 25,
  no_common_point = 26,
  // Facets to be fitted within a tolerance.
  beyond_tolerance = 27,
  // A build without Qhull.
  hull_unavailable = 28,
};

/// The fault as text, e.g. "is on the line of its neighbours".
const char* fault_text(Fault fault);

}  // namespace halfspace
