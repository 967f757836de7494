// halfspace/shape.h: what is refused, and what is wrong with a polygon. Its numbers are the oracles'
// business.

#include <cmath>
#include <cstring>
#include <limits>

#include "capi/refusals.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
const Points triangle = {{0, 0}, {1, 0}, {0, 1}};

struct Faulty {
  const char* what;
  std::int32_t kind;
  std::int64_t vertex;
  Points vertices;
};

const Faulty faulty_polygons[] = {
    {"nothing", HS_FAULT_TOO_FEW_VERTICES, -1, {}},
    {"two vertices", HS_FAULT_TOO_FEW_VERTICES, -1, {{0, 0}, {1, 0}}},
    {"NaN", HS_FAULT_NOT_FINITE, 1, {{0, 0}, {nan, 0}, {0, 1}}},
    {"infinity", HS_FAULT_NOT_FINITE, 2, {{0, 0}, {1, 0}, {0, -inf}}},
    {"too large to square", HS_FAULT_NOT_FINITE, 1, {{0, 0}, {1e200, 0}, {0, 1}}},
    {"too small to square", HS_FAULT_NOT_FINITE, -1, {{0, 0}, {1e-200, 0}, {0, 1e-200}}},
    {"repeated", HS_FAULT_REPEATED_VERTEX, 2, {{0, 0}, {1, 0}, {1, 0}, {0, 1}}},
    {"last repeats first", HS_FAULT_REPEATED_VERTEX, 0, {{0, 0}, {1, 0}, {0, 1}, {0, 0}}},
    {"collinear", HS_FAULT_COLLINEAR_VERTEX, 1, {{0, 0}, {1, 0}, {2, 0}, {0, 2}}},
    {"collinear to rounding", HS_FAULT_COLLINEAR_VERTEX, 1, {{0, 0}, {0.1, 0.1}, {0.3, 0.1 + 0.2}, {0, 2}}},
    {"re-entrant", HS_FAULT_NOT_CONVEX, 2, {{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}},
    {"bow tie", HS_FAULT_SELF_CROSSING, -1, {{0, 0}, {1, 1}, {1, 0}, {0, 1}}},
    {"twice around", HS_FAULT_SELF_CROSSING, -1, {{3, 0}, {-2, 2}, {1, -3}, {1, 3}, {-2, -2}}},
    {"a strip narrower than 1e-75", HS_FAULT_NOT_FINITE, -1, {{0, 0}, {1, 0}, {1, 1e-100}, {0, 1e-100}}},
    {"narrower than 1e-75", HS_FAULT_NOT_FINITE, -1, {{0, 0}, {1, 0}, {0.5, 1e-76}}},
    {"all on a line", HS_FAULT_ZERO_AREA, -1, {{0, 0}, {1, 1}, {2, 2}}},
};

}  // namespace

TEST_CASE("what is wrong with a polygon is said, and it is not made") {
  const Context context = make_context();
  for (const Faulty& f : faulty_polygons) {
    INFO(f.what);
    hs_fault fault{-1, -1, -2, -2};
    REQUIRE(hs_polygon_check(context.get(), view_of(f.vertices), &fault) == HS_OK);
    CHECK(fault.kind == f.kind);
    CHECK(fault.vertex == f.vertex);
    CHECK(fault.face == -1);
    CHECK(fault.reserved == 0);
    hs_shape* shape = no_shape;
    CHECK(hs_polygon_create(context.get(), view_of(f.vertices), &shape) == HS_ERROR_GEOMETRY);
    CHECK(shape == no_shape);
    const std::string text = hs_context_last_error(context.get());
    CHECK(text.find("hs_polygon_create: vertices") == 0);
    if (fault.vertex >= 0) CHECK(text.find("[" + std::to_string(fault.vertex) + "]") != std::string::npos);
  }
  hs_fault fault{-1, -1, -2, -2};
  for (Points good : {triangle, Points{{0, 1}, {1, 0}, {0, 0}}}) {  // either order
    REQUIRE(hs_polygon_check(context.get(), view_of(good), &fault) == HS_OK);
    CHECK(fault.kind == HS_FAULT_NONE);
    CHECK(fault.vertex == -1);
  }
}

TEST_CASE("shape functions refuse what is missing") {
  const Context context = make_context();
  hs_context* c = context.get();
  const hs_view v = view_of(triangle);
  hs_fault fault;
  hs_shape* shape = no_shape;
  CHECK(hs_polygon_check(nullptr, v, &fault) == HS_ERROR_ARGUMENT);
  CHECK(hs_polygon_create(nullptr, v, &shape) == HS_ERROR_ARGUMENT);
  CHECK(hs_polygon_create_hull(nullptr, v, &shape) == HS_ERROR_ARGUMENT);
  CHECK(hs_shape_get_properties(nullptr, nullptr, 0) == HS_ERROR_ARGUMENT);
  CHECK(hs_shape_get_vertices(nullptr, {}, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(hs_shape_get_halfspaces(nullptr, {}, nullptr, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(shape == no_shape);

  const Shape made = make_shape(c, triangle);
  check_refusals(c, "hs_polygon_check", {{"fault", "NULL", [&] { return hs_polygon_check(c, v, nullptr); }}});
  check_refusals(c, "hs_polygon_create",
                 {{"shape", "NULL", [&] { return hs_polygon_create(c, v, nullptr); }}});
  check_refusals(c, "hs_polygon_create_hull",
                 {{"shape", "NULL", [&] { return hs_polygon_create_hull(c, v, nullptr); }}});
  const auto nowhere = [&] {
    return hs_shape_get_properties(made.get(), nullptr, sizeof(hs_shape_properties));
  };
  check_refusals(c, "hs_shape_get_properties", {{"properties", "NULL", nowhere}});
}

TEST_CASE("a hull is refused for what is no number and for what has no area") {
  const Context context = make_context();
  hs_context* c = context.get();
  hs_shape* shape = no_shape;
  const auto hull = [&](const Points& points) { return hs_polygon_create_hull(c, view_of(points), &shape); };
  check_refusals(c, "hs_polygon_create_hull",
                 {{"points[1]", "nan",
                   [&] {
                     return hull({{0, 0}, {nan, 0}, {0, 1}});
                   }},
                  {"points[2]", "inf",
                   [&] {
                     return hull({{0, 0}, {1, 0}, {0, inf}});
                   }},
                  {"points", "0 points", [&] { return hull({}); }, HS_ERROR_GEOMETRY},
                  {"points", "1 points",
                   [&] {
                     return hull({{2, 3}});
                   },
                   HS_ERROR_GEOMETRY},
                  {"points", "4 points",
                   [&] {
                     return hull({{2, 3}, {2, 3}, {2, 3}, {2, 3}});
                   },
                   HS_ERROR_GEOMETRY},
                  {"points", "3 points",
                   [&] {
                     return hull({{0, 0}, {1, 1}, {3, 3}});
                   },
                   HS_ERROR_GEOMETRY}});
  CHECK(shape == no_shape);
}

TEST_CASE("a boundary is refused for ends and depths that bound nothing") {
  const Context context = make_context();
  hs_context* c = context.get();
  hs_shape* shape = no_shape;
  struct End {
    double xyz[3];
  };
  const End here{{3, 4, nan}}, there{{5, 4, inf}};  // the last value is not read
  const auto boundary = [&](End first, End second, double depth) {
    return [=, &shape] {
      return hs_polygon_create_boundary(c, nullptr, first.xyz, second.xyz, nullptr, depth, &shape);
    };
  };
  const auto in_chain = [&](End before, End after) {
    return [=, &shape] {
      return hs_polygon_create_boundary(c, before.xyz, here.xyz, there.xyz, after.xyz, 1, &shape);
    };
  };
  const double *first = here.xyz, *second = there.xyz;
  const auto call = [&](const double* from, const double* to, hs_shape** made) {
    return hs_polygon_create_boundary(c, nullptr, from, to, nullptr, 1, made);
  };
  CHECK(hs_polygon_create_boundary(nullptr, nullptr, first, second, nullptr, 1, &shape) == HS_ERROR_ARGUMENT);
  check_refusals(c, "hs_polygon_create_boundary",
                 {{"shape", "NULL", [&] { return call(first, second, nullptr); }},
                  {"first", "NULL", [&] { return call(nullptr, second, &shape); }},
                  {"second", "NULL", [&] { return call(first, nullptr, &shape); }},
                  {"first[0]", "nan", boundary({{nan, 4, 0}}, there, 1)},
                  {"first[1]", "inf", boundary({{3, inf, 0}}, there, 1)},
                  {"second[0]", "-inf", boundary(here, {{-inf, 4, 0}}, 1)},
                  {"second[1]", "e+75", boundary(here, {{5, 1.5e75, 0}}, 1)},
                  {"second", "(3, 4)", boundary(here, here, 1)},
                  {"before[1]", "nan", in_chain({{2, nan, 0}}, {{6, 4, 0}})},
                  {"before", "(3, 4)", in_chain(here, {{6, 4, 0}})},
                  {"after[0]", "-inf", in_chain({{2, 4, 0}}, {{-inf, 4, 0}})},
                  {"after", "(5, 4)", in_chain({{2, 4, 0}}, there)},
                  {"before", "(4, 4)", in_chain({{4, 4, 0}}, {{6, 4, 0}})},  // straight back
                  {"after", "(1, 4)", in_chain({{2, 4, 0}}, {{1, 4, 0}})},
                  {"depth", "0", boundary(here, there, 0)},
                  {"depth", "-1", boundary(here, there, -1)},
                  {"depth", "nan", boundary(here, there, nan)},
                  {"depth", "inf", boundary(here, there, inf)},
                  {"depth", "1e-17", boundary(here, there, 1e-17), HS_ERROR_GEOMETRY},  // lost in 3 and 4
                  {"depth", "1e+75", boundary(here, {{5e74, 0, 0}}, 1e75), HS_ERROR_GEOMETRY}});
  CHECK(shape == no_shape);
  REQUIRE(call(first, second, &shape) == HS_OK);
  const Shape made(shape);
  Points vertices(4);
  REQUIRE(hs_shape_get_vertices(made.get(), mutable_view_of(vertices), nullptr) == HS_OK);
  double least = inf;
  for (const Point& vertex : vertices) least = std::min(least, vertex.y);
  CHECK(least == 4);  // at the left of the way is above
}

TEST_CASE("hs_polygon_clean refuses bad input and reports what it changed") {
  const Context context = make_context();
  hs_context* c = context.get();
  const Points given = {{0, 1}, {0, 1},   {1, 1},
                        {1, 0}, {0.5, 0}, {0, 0}};  // clockwise, one repeated, one straight
  Points out(6);
  std::int64_t count = -7;
  hs_clean_report report{-1, -1, -1, -1};
  const auto clean = [&](double tolerance) {
    return hs_polygon_clean(c, view_of(given), tolerance, mutable_view_of(out), &count, &report);
  };
  CHECK(hs_polygon_clean(nullptr, view_of(given), 0, mutable_view_of(out), &count, &report) ==
        HS_ERROR_ARGUMENT);
  check_refusals(
      c, "hs_polygon_clean",
      {{"tolerance", "-1", [&] { return clean(-1); }},
       {"tolerance", "nan", [&] { return clean(nan); }},
       {"tolerance", "inf", [&] { return clean(inf); }},
       {"count", "NULL",
        [&] { return hs_polygon_clean(c, view_of(given), 0, mutable_view_of(out), nullptr, &report); }},
       {"vertices.count", "-1",
        [&] {
          return hs_polygon_clean(c, {&given[0].x, &given[0].y, nullptr, 16, -1}, 0, mutable_view_of(out),
                                  &count, &report);
        }},
       {"cleaned.stride", "3",
        [&] {
          return hs_polygon_clean(c, view_of(given), 0, {&out[0].x, &out[0].y, nullptr, 3, 6}, &count,
                                  &report);
        }},
       {"vertices[1]", "nan", [&] {
          const Points bad = {{0, 0}, {nan, 1}, {1, 1}};
          return hs_polygon_clean(c, view_of(bad), 0, mutable_view_of(out), &count, &report);
        }}});
  CHECK(count == -7);
  CHECK(report.welded == -1);

  REQUIRE(clean(0) == HS_OK);
  CHECK(count == 4);
  CHECK(report.welded == 1);
  CHECK(report.straightened == 1);
  CHECK(report.reversed == 1);
  CHECK(report.reserved == 0);
  out.resize(std::size_t(count));
  CHECK(make_shape(c, out));

  Points two(2);
  CHECK(hs_polygon_clean(c, view_of(given), 0, mutable_view_of(two), &count, nullptr) == HS_NOTE_TRUNCATED);
  CHECK(count == 4);
}

TEST_CASE("hs_shape_cut refuses bad input; a line outside leaves one part") {
  const Context context = make_context();
  hs_context* c = context.get();
  const Shape shape = make_shape(c, triangle);
  hs_shape* behind = no_shape;
  hs_shape* ahead = no_shape;
  const auto cut = [&](double px, double py, double nx, double ny) {
    const double point[3] = {px, py, nan}, normal[3] = {nx, ny, nan};  // z is ignored in 2D
    return hs_shape_cut(shape.get(), point, normal, &behind, &ahead);
  };
  const double one[3] = {0.2, 0.2, 0};
  CHECK(hs_shape_cut(nullptr, one, one, &behind, &ahead) == HS_ERROR_ARGUMENT);
  check_refusals(
      c, "hs_shape_cut",
      {{"point", "NULL", [&] { return hs_shape_cut(shape.get(), nullptr, one, &behind, &ahead); }},
       {"normal", "NULL", [&] { return hs_shape_cut(shape.get(), one, nullptr, &behind, &ahead); }},
       {"behind", "NULL", [&] { return hs_shape_cut(shape.get(), one, one, nullptr, &ahead); }},
       {"ahead", "NULL", [&] { return hs_shape_cut(shape.get(), one, one, &behind, nullptr); }},
       {"point", "nan", [&] { return cut(nan, 0, 1, 0); }},
       {"point", "inf", [&] { return cut(0, -inf, 1, 0); }},
       {"normal", "nan", [&] { return cut(0, 0, nan, 0); }},
       {"normal", "inf", [&] { return cut(0, 0, 1, inf); }},
       {"normal", "(0, 0)", [&] { return cut(0, 0, 0, 0); }}});
  CHECK(behind == no_shape);
  CHECK(ahead == no_shape);

  struct Line {
    double px, nx;
    bool has_behind, has_ahead;
  };
  for (const Line& l :
       {Line{0.5, 1, true, true}, Line{2, 1, true, false}, Line{-1, 1, false, true}, Line{0, 1, false, true},
        Line{1, 1, true, false}, Line{0.5, 1e-300, true, true}, Line{0.5, 1e300, true, true},
        Line{1e300, 1, true, false}, Line{-1e300, 1, false, true}}) {
    INFO("line at x = " << l.px << ", normal " << l.nx);
    REQUIRE(cut(l.px, 0, l.nx, 0) == HS_OK);
    const Shape parts[2] = {Shape(behind), Shape(ahead)};
    CHECK(bool(parts[0]) == l.has_behind);
    CHECK(bool(parts[1]) == l.has_ahead);
  }
}

TEST_CASE("whatever a line leaves of a sliver, one part is there, and alone it is the whole to the bit") {
  const Context context = make_context();
  // Points in line to rounding, 6.6 long, that end where the line is.
  Points sliver;
  for (int k = 0; k < 24; ++k) {
    const double at = k < 4 ? -7.5e-74 : -4.6875;
    sliver.push_back({at * (1 + k * 2e-12), at * (1 + (k + 0.5) * 2e-12)});
  }
  hs_shape* hull = nullptr;
  require_ok(hs_polygon_create_hull(context.get(), view_of(sliver), &hull), context.get());
  const Shape whole(hull);
  long alone = 0;
  for (const double x : {0.0, -1e-80, -1.0, -2.5, -4.6875, 1e-12, 1e60, -1e60}) {
    for (const Point& normal :
         {Point{1, 0}, Point{-1, 0}, Point{1, 1}, Point{1, -1}, Point{-1, 1}, Point{0, 1}}) {
      const double point[3] = {x, x, 0}, along[3] = {normal.x, normal.y, 0};
      hs_shape *behind = nullptr, *ahead = nullptr;
      INFO("line through " << x << " along " << normal.x << ", " << normal.y);
      const hs_status status = hs_shape_cut(whole.get(), point, along, &behind, &ahead);
      const Shape parts[2] = {Shape(behind), Shape(ahead)};
      if (status == HS_ERROR_GEOMETRY) continue;
      REQUIRE(status == HS_OK);
      CHECK((behind || ahead));
      if (behind && ahead) continue;
      ++alone;
      const Points expected = vertices_of(whole.get()), found = vertices_of(behind ? behind : ahead);
      REQUIRE(found.size() == expected.size());
      CHECK(std::memcmp(found.data(), expected.data(), found.size() * sizeof(Point)) == 0);
    }
  }
  CHECK(alone > 10);
}

}  // namespace halfspace_test
