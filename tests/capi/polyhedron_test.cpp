// halfspace/shape.h in space: what is refused, and what is wrong with a polyhedron.

#include <algorithm>
#include <cstring>
#include <limits>

#include "capi/polyhedra.h"
#include "capi/refusals.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

hs_shape* const no_shape = reinterpret_cast<hs_shape*>(0x10);  // a value that a refused call must leave alone

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
    {"two tetrahedra",
     HS_FAULT_NOT_ONE_SURFACE,
     -1,
     -1,
     {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}},
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {6, 4, 7}}}},
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

TEST_CASE("polyhedron functions refuse what is missing, negative or too much") {
  const Context context = make_context();
  hs_context* c = context.get();
  const Solid solid = cube();
  const hs_view v = view_of(solid.vertices);
  const std::int32_t *sizes = solid.faces.sizes.data(), *indices = solid.faces.vertices.data();
  hs_fault fault;
  hs_shape* shape = no_shape;
  CHECK(hs_polyhedron_check(nullptr, v, sizes, 6, indices, &fault) == HS_ERROR_ARGUMENT);
  CHECK(hs_polyhedron_create(nullptr, v, sizes, 6, indices, &shape) == HS_ERROR_ARGUMENT);
  CHECK(hs_polyhedron_create_hull(nullptr, v, &shape) == HS_ERROR_ARGUMENT);
  CHECK(hs_polyhedron_create_from_halfspaces(nullptr, v, nullptr, &shape) == HS_ERROR_ARGUMENT);
  CHECK(hs_shape_get_faces(nullptr, nullptr, 0, nullptr, 0, nullptr, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(hs_shape_get_edges(nullptr, nullptr, 0, nullptr) == HS_ERROR_ARGUMENT);

  const std::int32_t negative[6] = {4, 4, -1, 4, 4, 4};
  std::vector<std::int32_t> many(3, 1 << 30);
  hs_view without_z = v, too_many = v;
  without_z.z = nullptr;
  too_many.count = std::int64_t(1) << 40;
  check_refusals(
      c, "hs_polyhedron_check",
      {{"fault", "NULL", [&] { return hs_polyhedron_check(c, v, sizes, 6, indices, nullptr); }},
       {"face_sizes", "NULL", [&] { return hs_polyhedron_check(c, v, nullptr, 6, indices, &fault); }},
       {"face_vertices", "NULL", [&] { return hs_polyhedron_check(c, v, sizes, 6, nullptr, &fault); }},
       {"face_count", "-2", [&] { return hs_polyhedron_check(c, v, sizes, -2, indices, &fault); }},
       {"face_sizes[2]", "-1", [&] { return hs_polyhedron_check(c, v, negative, 6, indices, &fault); }},
       {"face_sizes", "3221225472",
        [&] { return hs_polyhedron_check(c, v, many.data(), 3, indices, &fault); }},
       {"vertices.count", "1099511627776",
        [&] { return hs_polyhedron_check(c, too_many, sizes, 6, indices, &fault); }},
       {"vertices.z", "NULL", [&] { return hs_polyhedron_check(c, without_z, sizes, 6, indices, &fault); }}});
  check_refusals(
      c, "hs_polyhedron_create",
      {{"shape", "NULL", [&] { return hs_polyhedron_create(c, v, sizes, 6, indices, nullptr); }},
       {"face_sizes", "NULL", [&] { return hs_polyhedron_create(c, v, nullptr, 6, indices, &shape); }}});
  check_refusals(
      c, "hs_polyhedron_create_hull",
      {{"shape", "NULL", [&] { return hs_polyhedron_create_hull(c, v, nullptr); }},
       {"points.count", "1099511627776", [&] { return hs_polyhedron_create_hull(c, too_many, &shape); }},
       {"points.z", "NULL", [&] { return hs_polyhedron_create_hull(c, without_z, &shape); }}});
  const double offsets[8] = {};
  check_refusals(
      c, "hs_polyhedron_create_from_halfspaces",
      {{"shape", "NULL", [&] { return hs_polyhedron_create_from_halfspaces(c, v, offsets, nullptr); }},
       {"offsets", "NULL", [&] { return hs_polyhedron_create_from_halfspaces(c, v, nullptr, &shape); }},
       {"normals.z", "NULL",
        [&] { return hs_polyhedron_create_from_halfspaces(c, without_z, offsets, &shape); }}});
  CHECK(shape == no_shape);

  const Shape made = make_polyhedron(c, solid);
  std::int32_t numbers[64];
  const auto faces = [&](std::int32_t* first, std::int64_t n, std::int32_t* all, std::int64_t m) {
    return [=, &made] { return hs_shape_get_faces(made.get(), first, n, all, m, nullptr, nullptr); };
  };
  check_refusals(c, "hs_shape_get_faces",
                 {{"first_of_face", "NULL", faces(nullptr, 7, numbers, 24)},
                  {"face_vertices", "NULL", faces(numbers, 7, nullptr, 24)},
                  {"face_capacity", "-1", faces(numbers, -1, numbers, 24)},
                  {"vertex_capacity", "-5", faces(numbers, 7, numbers, -5)}});
  check_refusals(
      c, "hs_shape_get_edges",
      {{"edge_vertices", "NULL", [&] { return hs_shape_get_edges(made.get(), nullptr, 12, nullptr); }},
       {"capacity", "-1", [&] { return hs_shape_get_edges(made.get(), numbers, -1, nullptr); }}});
  double coordinates[24];
  check_refusals(
      c, "hs_shape_get_vertices",
      {{"vertices.z", "NULL", [&] {
          return hs_shape_get_vertices(made.get(), {coordinates, coordinates + 1, nullptr, 16, 8}, nullptr);
        }}});
}

TEST_CASE("points and half-spaces without a polyhedron are refused with the reason") {
  const Context context = make_context();
  hs_context* c = context.get();
  hs_shape* shape = no_shape;
  const auto hull = [&](Points3 points) {
    return [&, points] { return hs_polyhedron_create_hull(c, view_of(points), &shape); };
  };
  check_refusals(
      c, "hs_polyhedron_create_hull",
      {{"points[1]", "nan", hull({{0, 0, 0}, {nan, 0, 0}, {0, 1, 0}, {0, 0, 1}})},
       {"points[3]", "inf", hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, inf}})},
       {"points[2]", "2e+50", hull({{0, 0, 0}, {1, 0, 0}, {0, 2e50, 0}, {0, 0, 1}}), HS_ERROR_GEOMETRY},
       {"points", "0 points", hull({}), HS_ERROR_GEOMETRY},
       {"points", "3 points", hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), HS_ERROR_GEOMETRY},
       {"points", "no volume", hull(box_corners({0, 0, 3}, {1, 1, 3})), HS_ERROR_GEOMETRY}});

  Points3 normals = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  std::vector<double> offsets(6, 1);
  const auto cut_out = [&](std::size_t i, const Point3& normal, double offset, std::size_t count = 6) {
    return [&, i, normal, offset, count] {
      Points3 n = normals;
      std::vector<double> o = offsets;
      n[i] = normal;
      o[i] = offset;
      n.resize(count);
      return hs_polyhedron_create_from_halfspaces(c, view_of(n), o.data(), &shape);
    };
  };
  check_refusals(c, "hs_polyhedron_create_from_halfspaces",
                 {{"half-space 2", "nan", cut_out(2, {0, nan, 0}, 1), HS_ERROR_GEOMETRY},
                  {"half-space 4", "inf", cut_out(4, {0, 0, -1}, inf), HS_ERROR_GEOMETRY},
                  {"half-space 3", "without direction", cut_out(3, {0, 0, 0}, 1), HS_ERROR_GEOMETRY},
                  {"6 half-spaces", "do not bound", cut_out(5, {0, 0, -1}, 1), HS_ERROR_GEOMETRY},
                  {"3 half-spaces", "do not bound", cut_out(0, {-1, 0, 0}, 1, 3), HS_ERROR_GEOMETRY},
                  {"6 half-spaces", "no point in common", cut_out(1, {1, 0, 0}, -2), HS_ERROR_GEOMETRY}});
  CHECK(shape == no_shape);
}

TEST_CASE("a cut of a polyhedron refuses bad input; a plane outside leaves one part") {
  const Context context = make_context();
  hs_context* c = context.get();
  const Shape shape = make_polyhedron(c, cube(2));
  hs_shape* behind = no_shape;
  hs_shape* ahead = no_shape;
  const auto cut = [&](const Point3& p, const Point3& n) {
    const double point[3] = {p.x, p.y, p.z}, normal[3] = {n.x, n.y, n.z};
    return hs_shape_cut(shape.get(), point, normal, &behind, &ahead);
  };
  check_refusals(c, "hs_shape_cut",
                 {{"point", "nan",
                   [&] {
                     return cut({0, 0, nan}, {1, 0, 0});
                   }},
                  {"normal", "inf",
                   [&] {
                     return cut({0, 0, 0}, {1, 0, -inf});
                   }},
                  {"normal", "(0, 0, 0)", [&] {
                     return cut({0, 0, 0}, {0, 0, 0});
                   }}});
  CHECK(behind == no_shape);
  CHECK(ahead == no_shape);

  struct Plane {
    double height, normal;
    bool has_behind, has_ahead;
  };
  for (const Plane& l : {Plane{0, 1, true, true}, Plane{2, 1, true, false}, Plane{-2, 1, false, true},
                         Plane{1, 1, true, false}, Plane{-1, 1, false, true}, Plane{1, -1, false, true},
                         Plane{1 - 0x1p-53, 1, true, false}, Plane{0.5, 1e-300, true, true},
                         Plane{0.5, 1e300, true, true}, Plane{1e300, 1, true, false}}) {
    INFO("plane at z = " << l.height << ", normal " << l.normal);
    REQUIRE(cut({0, 0, l.height}, {0, 0, l.normal}) == HS_OK);
    const Shape parts[2] = {Shape(behind), Shape(ahead)};
    CHECK(bool(parts[0]) == l.has_behind);
    CHECK(bool(parts[1]) == l.has_ahead);
  }
}

TEST_CASE("a polyhedron is refused where a polygon is wanted") {
  const Context context = make_context();
  const Shape shape = make_polyhedron(context.get(), cube());
  hs_world_def def;
  REQUIRE(hs_world_def_init(&def, sizeof def) == HS_OK);
  hs_world* made = nullptr;
  REQUIRE(hs_world_create(context.get(), &def, &made) == HS_OK);
  const World world(made);
  std::int32_t material = -1;
  REQUIRE(hs_world_add_material(world.get(), 1000, &material) == HS_OK);
  hs_block_def block_def;
  REQUIRE(hs_block_def_init(&block_def, sizeof block_def, shape.get()) == HS_OK);
  block_def.material = material;
  hs_block block = 77;
  check_refusals(
      context.get(), "hs_world_add_block",
      {{"shape", "3", [&] { return hs_world_add_block(world.get(), shape.get(), &block_def, &block); }}});
  CHECK(block == 77);
}

}  // namespace halfspace_test
