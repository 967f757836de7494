#include "geometry/fault.h"

namespace halfspace {

const char* fault_text(Fault fault) {
  switch (fault) {
    case Fault::none:
      return "is valid";
    case Fault::too_few_vertices:
      return "has fewer than 3 vertices";
    case Fault::not_finite:
      return "is not finite, or beyond 1e75, or the whole is smaller or narrower than 1e-75";
    case Fault::repeated_vertex:
      return "repeats the vertex before it";
    case Fault::collinear_vertex:
      return "is on the line of its neighbours";
    case Fault::not_convex:
      return "is a re-entrant corner";
    case Fault::self_crossing:
      return "makes the outline cross or fold onto itself";
    case Fault::zero_area:
      return "has no area: all vertices are on one line";
    case Fault::fewer_than_four:
      return "has fewer than 4 vertices or fewer than 4 faces";
    case Fault::face_too_short:
      return "has fewer than 3 vertices";
    case Fault::no_such_vertex:
      return "refers to a vertex that is not there";
    case Fault::vertex_twice_in_face:
      return "goes through the same vertex twice";
    case Fault::unused_vertex:
      return "belongs to no face";
    case Fault::unmatched_edge:
      return "has an edge that no other face, or more than one, or one of the same direction shares";
    case Fault::vertex_inside_edge:
      return "belongs to two faces only: it is not a corner";
    case Fault::not_one_surface:
      return "is not one closed surface without holes: vertices - edges + faces is not 2";
    case Fault::out_of_range:
      return "is not finite, or beyond 1e50, or the whole is smaller than 1e-50";
    case Fault::coinciding_vertices:
      return "is where another vertex is";
    case Fault::zero_volume:
      return "has no volume: it is flat to rounding";
    case Fault::face_without_area:
      return "has no area: its vertices are on one line to rounding";
    case Fault::face_not_plane:
      return "is not plane: a vertex is off its plane by more than rounding";
    case Fault::vertex_outside_face:
      return "has a vertex outside: the shape is not convex";
    case Fault::coplanar_faces:
      return "is in one plane with a neighbour: they are one face";
    case Fault::hull_failed:
      return "lies so close to degenerate that rounding hides the hull";
    case Fault::no_direction:
      return "has a normal without direction";
    case Fault::unbounded:
      return "do not bound a region";
    case Fault::no_common_point:
      return "have no point in common, or a region flat to rounding";
    case Fault::beyond_tolerance:
      return "has a dent deeper than the tolerance";
    case Fault::hull_unavailable:
      return "needs a hull, which this build cannot compute: it was built without Qhull";
  }
  return "is faulty";
}

}  // namespace halfspace
