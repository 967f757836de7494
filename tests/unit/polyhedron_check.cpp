// What is no fault of a polyhedron. The faults are tested through the C API, which names them all.

#include <algorithm>

#include "catch.h"
#include "polyhedra.h"

using namespace halfspace;
using namespace halfspace::test;

TEST_CASE("either orientation, short edges and small angles are legal") {
  Polyhedron inside_out = box({1, 2, 3});
  for (std::int32_t f = 0; f < inside_out.face_count(); ++f) {
    std::reverse(inside_out.face_vertices.begin() + inside_out.first_of_face[std::size_t(f)],
                 inside_out.face_vertices.begin() + inside_out.first_of_face[std::size_t(f) + 1]);
  }
  CHECK(shape_of(completed(std::move(inside_out))).volume() == 6);

  Polyhedron slab = box({1, 1, 1e-12});
  CHECK(complete_polyhedron(slab).fault == Fault::none);
  // A pyramid 1e-9 high on a square, and a tetrahedron with an edge of 1e-9.
  Polyhedron flat = faces_of({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1e-9}},
                             {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  CHECK(complete_polyhedron(flat).fault == Fault::none);
  Polyhedron wedge =
      faces_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 1e-9}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  CHECK(complete_polyhedron(wedge).fault == Fault::none);
}

TEST_CASE("a polyhedron that was completed passes the check, and is completed to the same") {
  for (const PlatonicSolid& solid : platonic_solids()) {
    const Polyhedron once = hull_of(solid.vertices);
    CHECK(check_polyhedron(once).fault == Fault::none);
    const Polyhedron twice = completed(copy_of(once));
    CHECK(once.face_vertices == twice.face_vertices);
    CHECK(once.normals == twice.normals);
  }
}
