// halfspace/shape.h in space: what is refused.

#include <limits>

#include "capi/polyhedra.h"
#include "capi/refusals.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

}  // namespace

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
  REQUIRE(hs_world_def_init(&def, sizeof def, 2) == HS_OK);
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
