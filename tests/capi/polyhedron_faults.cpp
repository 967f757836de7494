// halfspace/shape.h in space: what is wrong with a polyhedron.

#include <limits>

#include "capi/polyhedra.h"
#include "capi/refusals.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const Points3 four = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Faces four_faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

/// The cube with one vertex elsewhere.
Solid cube_with(std::size_t vertex, const Point3& place) {
  Solid solid = cube(2);
  solid.vertices[vertex] = place;
  return solid;
}

struct Faulty {
  const char* what;
  std::int32_t kind;
  std::int64_t vertex;
  std::int64_t face;
  Solid solid;
};

const Faulty faulty_polyhedra[] = {
    {"nothing", HS_FAULT_FEWER_THAN_FOUR, -1, -1, {}},
    {"three vertices",
     HS_FAULT_FEWER_THAN_FOUR,
     -1,
     -1,
     {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}, {0, 1, 2}, {0, 2, 1}}}},
    {"three faces", HS_FAULT_FEWER_THAN_FOUR, -1, -1, {four, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}}},
    {"a face of two", HS_FAULT_FACE_TOO_SHORT, -1, 2, {four, {{0, 2, 1}, {0, 1, 3}, {1, 2}, {2, 0, 3}}}},
    {"a face of none", HS_FAULT_FACE_TOO_SHORT, -1, 1, {four, {{0, 2, 1}, {}, {1, 2, 3}, {2, 0, 3}}}},
    {"beyond the last", HS_FAULT_NO_SUCH_VERTEX, 4, 1, {four, {{0, 2, 1}, {0, 1, 4}, {1, 2, 3}, {2, 0, 3}}}},
    {"below 0", HS_FAULT_NO_SUCH_VERTEX, -7, 0, {four, {{0, 2, -7}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}},
    {"twice in a face",
     HS_FAULT_VERTEX_TWICE_IN_FACE,
     0,
     3,
     {four, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3, 0}}}},
    {"a loose vertex",
     HS_FAULT_UNUSED_VERTEX,
     4,
     -1,
     {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.1, 0.1}}, four_faces}},
    {"a face missing",
     HS_FAULT_UNMATCHED_EDGE,
     5,
     1,
     {cube().vertices, {{0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}}},
    {"a face there twice",
     HS_FAULT_UNMATCHED_EDGE,
     1,
     0,
     {four, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 3}}}},
    {"a face the wrong way round",
     HS_FAULT_UNMATCHED_EDGE,
     0,
     0,
     {four, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}},
    {"in the middle of an edge",
     HS_FAULT_VERTEX_INSIDE_EDGE,
     4,
     -1,
     {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}},
      {{0, 2, 1, 4}, {0, 4, 1, 3}, {1, 2, 3}, {2, 0, 3}}}},
    {"two tetrahedra apart",
     HS_FAULT_NOT_ONE_SURFACE,
     -1,
     -1,
     {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {6, 4, 7}}}},
    {"two tetrahedra with a vertex in common",
     HS_FAULT_NOT_ONE_SURFACE,
     -1,
     -1,
     {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {5, 6, 0}}}},
    {"NaN", HS_FAULT_OUT_OF_RANGE, 3, -1, cube_with(3, {1, nan, -1})},
    {"too large", HS_FAULT_OUT_OF_RANGE, 6, -1, cube_with(6, {-1, 1, 2e50})},
    {"too small", HS_FAULT_OUT_OF_RANGE, -1, -1, cube(1e-51)},
    {"at one place", HS_FAULT_COINCIDING_VERTICES, 7, -1, cube_with(7, {-1, 1, 1})},
    {"flat", HS_FAULT_ZERO_VOLUME, -1, -1, box_3d({0, 0, 0}, {1, 1, 0})},
    {"a face drawn out to a line",
     HS_FAULT_FACE_WITHOUT_AREA,
     -1,
     0,
     {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}},
      {{0, 4, 1}, {0, 2, 4}, {4, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}},
    {"a bent face", HS_FAULT_FACE_NOT_PLANE, 4, 1, cube_with(7, {1, 1, 1.001})},
    {"a roof turned inwards",
     HS_FAULT_VERTEX_OUTSIDE_FACE,
     6,
     5,
     {{{0, 0, 0},
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
       {8, 9, 6, 7}}}},
    {"a square in two triangles",
     HS_FAULT_COPLANAR_FACES,
     -1,
     1,
     {cube().vertices,
      {{0, 2, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}}},
};

hs_status check_polyhedron(hs_context* context, const Solid& solid, hs_fault* fault) {
  return hs_polyhedron_check(context, view_of(solid.vertices), solid.faces.sizes.data(),
                             std::int64_t(solid.faces.sizes.size()), solid.faces.vertices.data(), fault);
}

std::string bracketed(std::int64_t i) { return "[" + std::to_string(i) + "]"; }

}  // namespace

TEST_CASE("what is wrong with a polyhedron is said with vertex and face, and it is not made") {
  const Context context = make_context();
  for (const Faulty& f : faulty_polyhedra) {
    INFO(f.what);
    hs_fault fault{-1, -1, -2, -2};
    REQUIRE(check_polyhedron(context.get(), f.solid, &fault) == HS_OK);
    CHECK(fault.kind == f.kind);
    CHECK(fault.vertex == f.vertex);
    CHECK(fault.face == f.face);
    CHECK(fault.reserved == 0);
    hs_shape* shape = no_shape;
    CHECK(create_polyhedron(context.get(), f.solid, &shape) == HS_ERROR_GEOMETRY);
    CHECK(shape == no_shape);
    const std::string text = hs_context_last_error(context.get());
    INFO("the text is: " << text);
    CHECK(text.find("hs_polyhedron_create: ") == 0);
    if (f.face >= 0) CHECK(text.find("face " + std::to_string(f.face)) != std::string::npos);
    if (f.vertex >= 0) CHECK(text.find("vertices" + bracketed(f.vertex)) != std::string::npos);
  }
  hs_fault fault{-1, -1, -2, -2};
  REQUIRE(check_polyhedron(context.get(), cube(), &fault) == HS_OK);
  CHECK(fault.kind == HS_FAULT_NONE);
  CHECK(fault.vertex == -1);
  CHECK(fault.face == -1);
}

}  // namespace halfspace_test
