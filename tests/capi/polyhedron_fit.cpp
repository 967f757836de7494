// halfspace/shape.h: polyhedra fitted to facets of a few digits, and what rests on their faces.

#include <cmath>
#include <limits>
#include <numbers>

#include "capi/polyhedra.h"
#include "capi/refusals.h"
#include "capi/world_fixture.h"

namespace halfspace_test {
namespace {

/// A point of a scene that no axis is along: dip 40 degrees, azimuth 12.
Point3 tilted(const Point3& p) {
  const double a = 12 * std::numbers::pi / 180, b = 40 * std::numbers::pi / 180;
  const double y = std::cos(b) * p.y - std::sin(b) * p.z, z = std::sin(b) * p.y + std::cos(b) * p.z;
  return {std::cos(a) * p.x - std::sin(a) * y + 3.21712345678,
          std::sin(a) * p.x + std::cos(a) * y - 1.48309876543, z + 0.77131357913};
}

/// A box as a file with so many decimals has it.
Solid written_box(const Point3& low, const Point3& high, int decimals) {
  Solid solid = box_3d(low, high);
  const double unit = std::pow(10, decimals);
  const auto written = [unit](double x) { return std::round(unit * x) / unit; };
  for (Point3& p : solid.vertices) {
    p = tilted(p);
    p = {written(p.x), written(p.y), written(p.z)};
  }
  return solid;
}

/// Each face cut into two triangles, as an STL file has them.
Solid in_triangles(const Solid& solid) {
  Solid triangles{solid.vertices, {}};
  for (std::size_t f = 0; f < 6; ++f) {
    const std::int32_t* v = &solid.faces.vertices[4 * f];
    triangles.faces.add({v[0], v[1], v[2]});
    triangles.faces.add({v[0], v[2], v[3]});
  }
  return triangles;
}

hs_status create_fitted(hs_context* context, const Solid& solid, double tolerance, hs_shape** shape,
                        hs_fit_report* report = nullptr) {
  return hs_polyhedron_create_fitted(context, view_of(solid.vertices), solid.faces.sizes.data(),
                                     std::int64_t(solid.faces.sizes.size()), solid.faces.vertices.data(),
                                     tolerance, shape, report);
}

Shape make_fitted(hs_context* context, const Solid& solid, double tolerance) {
  hs_shape* shape = nullptr;
  require_ok(create_fitted(context, solid, tolerance, &shape), context);
  return Shape(shape);
}

hs_block add(hs_context* context, hs_world* world, const hs_shape* shape, std::int32_t kind) {
  hs_block_def def;
  require_ok(hs_block_def_init(&def, sizeof def, shape), context);
  def.kind = kind;
  hs_block block = 0;
  require_ok(hs_world_add_block(world, shape, &def, &block), context);
  return block;
}

double bond_area(hs_context* context, const hs_shape* lower, const hs_shape* upper) {
  const World world = make_world(context, world_def(3));
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 2000, &material), context);
  const hs_block first = add(context, world.get(), lower, HS_BLOCK_FIXED),
                 second = add(context, world.get(), upper, HS_BLOCK_RIGID);
  hs_bond_def def;
  require_ok(hs_bond_def_init(&def, sizeof def), context);
  def.normal_stiffness = def.shear_stiffness = 1e10;
  def.tensile_strength = def.cohesion = 1e6;
  require_ok(hs_world_bond_blocks(world.get(), first, second, &def), context);
  hs_bond bond{};
  std::int64_t count = 0;
  require_ok(hs_world_get_bonds(world.get(), &bond, 1, &count), context);
  REQUIRE(count == 1);
  return bond.area;
}

}  // namespace

TEST_CASE("flush cubes written with 3 to 12 decimals have whole bonds, of quads and triangles") {
  const Context context = make_context();
  hs_context* c = context.get();
  for (int decimals = 3; decimals <= 12; ++decimals) {
    CAPTURE(decimals);
    const double last_digit = std::pow(10, -decimals);
    for (const bool has_triangles : {false, true}) {
      Solid below = written_box({-0.5, -0.5, -1}, {0.5, 0.5, 0}, decimals),
            above = written_box({-0.5, -0.5, 0}, {0.5, 0.5, 1}, decimals);
      if (has_triangles) below = in_triangles(below), above = in_triangles(above);
      const Shape lower = make_fitted(c, below, 2 * last_digit),
                  upper = make_fitted(c, above, 2 * last_digit);
      CHECK(properties_of(lower.get()).face_count == 6);
      CHECK(properties_of(upper.get()).vertex_count == 8);
      // Sides of unit squares move by some units of the last digit.
      const double rounding = 16 * last_digit + 1e-14;
      CHECK(bond_area(c, lower.get(), upper.get()) == Approx(1).epsilon(rounding));
    }
  }
}

TEST_CASE("a bond adds up all pairs of faces where files split them") {
  const Context context = make_context();
  hs_context* c = context.get();
  // Hulls of 12 decimals merge to rounding only: triangles, whose planes are one for bonds.
  const Shape lower = make_hull(c, written_box({-0.5, -0.5, -1}, {0.5, 0.5, 0}, 12).vertices),
              upper = make_hull(c, written_box({-0.5, -0.5, 0}, {0.5, 0.5, 1}, 12).vertices);
  CHECK(properties_of(lower.get()).face_count > 6);
  CHECK(bond_area(c, lower.get(), upper.get()) == Approx(1).epsilon(1e-10));
}

TEST_CASE("hs_polyhedron_create_fitted reports merged facets and names a dent beyond the tolerance") {
  const Context context = make_context();
  hs_context* c = context.get();
  Solid dented = in_triangles(cube());
  // The upper face about its middle, which is pushed in by 1e-3.
  dented.vertices.push_back({0, 0, 0.5 - 1e-3});
  Faces faces;
  for (std::size_t f = 0; f < 12; ++f) {
    const std::int32_t* v = &dented.faces.vertices[3 * f];
    if (f != 2 && f != 3) faces.add({v[0], v[1], v[2]});
  }
  for (const std::vector<std::int32_t>& loop :
       {std::vector<std::int32_t>{4, 5, 8}, {5, 7, 8}, {7, 6, 8}, {6, 4, 8}})
    faces.add(loop);
  dented.faces = faces;

  hs_shape* shape = nullptr;
  hs_fit_report report{};
  REQUIRE(create_fitted(c, dented, 1e-3, &shape, &report) == HS_OK);
  const Shape taken(shape);
  CHECK(report.fault.kind == HS_FAULT_NONE);
  CHECK(report.merged == 8);
  CHECK(report.deviation == Approx(8e-4).epsilon(1e-6));
  CHECK(report.moved == Approx(8e-4).epsilon(1e-6));
  CHECK(report.sufficient_tolerance == 0);
  CHECK(properties_of(taken.get()).face_count == 6);

  shape = no_shape;
  check_refusals(c, "hs_polyhedron_create_fitted",
                 {{"vertices[8] = (0, 0, 0.499)", "tolerance is 1e-05",
                   [&] { return create_fitted(c, dented, 1e-5, &shape, &report); }, HS_ERROR_GEOMETRY}});
  CHECK(report.fault.kind == HS_FAULT_BEYOND_TOLERANCE);
  CHECK(report.fault.vertex == 8);
  CHECK(report.deviation == Approx(1e-3).epsilon(1e-12));
  REQUIRE(report.sufficient_tolerance > 0);
  CHECK(shape == no_shape);
  REQUIRE(create_fitted(c, dented, report.sufficient_tolerance, &shape) == HS_OK);
  const Shape again(shape);

  shape = no_shape;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check_refusals(c, "hs_polyhedron_create_fitted",
                 {{"tolerance", "-1", [&] { return create_fitted(c, cube(), -1, &shape); }},
                  {"tolerance", "nan", [&] { return create_fitted(c, cube(), nan, &shape); }},
                  {"shape", "NULL", [&] { return create_fitted(c, cube(), 0, nullptr); }},
                  {"face_sizes", "NULL",
                   [&] {
                     return hs_polyhedron_create_fitted(c, view_of(dented.vertices), nullptr, 6, nullptr, 0,
                                                        &shape, nullptr);
                   }},
                  {"belongs to no face", "vertices[8]",
                   [&] {
                     Solid loose = cube();
                     loose.vertices.push_back({0, 0, 0});
                     return create_fitted(c, loose, 0, &shape);
                   },
                   HS_ERROR_GEOMETRY}});
  CHECK(create_fitted(nullptr, cube(), 0, &shape) == HS_ERROR_ARGUMENT);
  CHECK(shape == no_shape);
}

}  // namespace halfspace_test
