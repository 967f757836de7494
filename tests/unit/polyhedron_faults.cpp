#include <algorithm>
#include <limits>

#include "catch.h"
#include "polyhedra.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

void expect_fault(Polyhedron polyhedron, Fault fault, std::int64_t vertex, std::int64_t face) {
  const PolyhedronFault report = complete_polyhedron(polyhedron);
  INFO(fault_text(fault));
  CHECK(int(report.fault) == int(fault));
  CHECK(report.vertex == vertex);
  CHECK(report.face == face);
}

const Cloud tetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

const Cloud box_corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                           {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};

Polyhedron tetrahedron_faces() { return faces_of(tetrahedron, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}); }

Polyhedron box_with(int vertex, const Vector<3>& place) {
  Polyhedron p = box({2, 2, 2});
  p.vertices[std::size_t(vertex)] = place;
  return p;
}

}  // namespace

TEST_CASE("each fault of how a polyhedron hangs together is named with its place") {
  expect_fault(faces_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}, {0, 1, 2}, {0, 2, 1}}),
               Fault::fewer_than_four, -1, -1);
  expect_fault(faces_of(tetrahedron, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}), Fault::fewer_than_four, -1, -1);
  expect_fault(faces_of(tetrahedron, {{0, 2, 1}, {0, 1, 3}, {1, 2}, {2, 0, 3}}), Fault::face_too_short, -1,
               2);
  expect_fault(faces_of(tetrahedron, {{0, 2, 1}, {0, 1, 4}, {1, 2, 3}, {2, 0, 3}}), Fault::no_such_vertex, 4,
               1);
  expect_fault(faces_of(tetrahedron, {{0, 2, -1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}), Fault::no_such_vertex,
               -1, 0);
  expect_fault(faces_of(tetrahedron, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3, 0}}),
               Fault::vertex_twice_in_face, 0, 3);

  Polyhedron with_a_loose_vertex = tetrahedron_faces();
  with_a_loose_vertex.vertices.push_back({0.1, 0.1, 0.1});
  expect_fault(std::move(with_a_loose_vertex), Fault::unused_vertex, 4, -1);

  // A face missing, a face there twice, a face the wrong way round.
  expect_fault(faces_of(box_corners, {{0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}),
               Fault::unmatched_edge, 5, 1);
  expect_fault(faces_of(tetrahedron, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 3}}),
               Fault::unmatched_edge, 1, 0);
  expect_fault(faces_of(tetrahedron, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}), Fault::unmatched_edge, 0,
               0);

  // A vertex in the middle of edge 0-1.
  expect_fault(faces_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}},
                        {{0, 2, 1, 4}, {0, 4, 1, 3}, {1, 2, 3}, {2, 0, 3}}),
               Fault::vertex_inside_edge, 4, -1);

  // Two tetrahedra apart, and two with a vertex in common.
  expect_fault(
      faces_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}},
               {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {6, 4, 7}}),
      Fault::not_one_surface, -1, -1);
  expect_fault(
      faces_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
               {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {5, 6, 0}}),
      Fault::not_one_surface, -1, -1);
}

TEST_CASE("each fault of where a polyhedron's vertices are is named with its place") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_fault(box_with(3, {1, nan, -1}), Fault::out_of_range, 3, -1);
  expect_fault(box_with(6, {-1, 1, 2e50}), Fault::out_of_range, 6, -1);
  expect_fault(box({1e-51, 1e-51, 1e-51}), Fault::out_of_range, -1, -1);
  expect_fault(box_with(7, {-1, 1, 1}), Fault::coinciding_vertices, 7, -1);
  expect_fault(box({1, 1, 0}), Fault::zero_volume, -1, -1);
  // All four corners are off the plane between them, 4 and 7 above.
  expect_fault(box_with(7, {1, 1, 1.001}), Fault::face_not_plane, 4, 1);
  // The roof of a house turned inwards: all faces plane, one ridge re-entrant.
  expect_fault(faces_of({{0, 0, 0},
                         {2, 0, 0},
                         {2, 2, 0},
                         {0, 2, 0},
                         {0, 0, 2},
                         {2, 0, 2},
                         {2, 2, 2},
                         {0, 2, 2},
                         {0, 1, 1},
                         {2, 1, 1}},
                        {{0, 3, 2, 1},
                         {0, 1, 5, 4},
                         {2, 3, 7, 6},
                         {1, 2, 6, 9, 5},
                         {3, 0, 4, 8, 7},
                         {4, 5, 9, 8},
                         {8, 9, 6, 7}}),
               Fault::vertex_outside_face, 6, 5);
  // The top of a box in two triangles.
  expect_fault(
      faces_of(box_corners,
               {{0, 2, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}),
      Fault::coplanar_faces, -1, 1);
  // A face drawn out to a line: 0, 1 and 4 are on it.
  expect_fault(faces_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}},
                        {{0, 4, 1}, {0, 2, 4}, {4, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}),
               Fault::face_without_area, -1, 0);
}

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
