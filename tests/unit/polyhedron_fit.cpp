#include <Eigen/Geometry>
#include <cmath>

#include "catch.h"
#include "geometry/polyhedron/facets.h"
#include "geometry/polyhedron/fit_plane.h"
#include "geometry/polyhedron/fit_polyhedron.h"
#include "geometry/polyhedron/support_tree.h"
#include "polyhedra.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// As a file states it that has so many decimals.
Cloud written(Cloud points, int decimals) {
  const double unit = std::pow(10, decimals);
  for (Vector<3>& p : points) p = (p * unit).array().round() / unit;
  return points;
}

/// The largest distance by which that moves a point.
double largest_rounding(int decimals) { return std::sqrt(3.0) / 2 * std::pow(10, -decimals); }

/// A unit cube that no axis is along, somewhere.
Cloud tilted_cube() {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.21, Vector<3>::UnitZ()) * Eigen::AngleAxisd(0.7, Vector<3>::UnitX()))
          .toRotationMatrix();
  Cloud corners;
  for (const Vector<3>& corner : box({1, 1, 1}).vertices)
    corners.push_back(turn * corner + Vector<3>(3.2171234567, -1.4830987654, 0.7713135791));
  return corners;
}

/// A unit cube with loops of triangles, each face cut into four about its middle, and the middle of the last
/// face, vertex 13 of facets 20 to 23, pushed in by so much.
Polyhedron dented_cube(double depth) {
  const Polyhedron cube = box({1, 1, 1});
  Polyhedron dented(std::pmr::get_default_resource());
  dented.vertices = cube.vertices;
  for (int f = 0; f < cube.face_count(); ++f) {
    Vector<3> middle = Vector<3>::Zero();
    for (std::size_t i = 0; i < 4; ++i) middle += 0.25 * cube.corner(f, i);
    if (f == 5) middle *= 1 - 2 * depth;
    dented.vertices.push_back(middle);
    for (std::size_t i = 0; i < 4; ++i) {
      dented.append_corner(cube.loop(f)[i]);
      dented.append_corner(cube.loop(f)[(i + 1) % 4]);
      dented.append_corner(8 + f);
      dented.end_face();
    }
  }
  return dented;
}

Polyhedron cloud_alone(const Cloud& points) {
  Polyhedron polyhedron(std::pmr::get_default_resource());
  polyhedron.vertices.assign(points.begin(), points.end());
  return polyhedron;
}

}  // namespace

TEST_CASE("a cube written with 3 to 12 decimals keeps its six faces, from points and from a file's faces") {
  for (int decimals = 3; decimals <= 12; ++decimals) {
    CAPTURE(decimals);
    const Cloud corners = written(tilted_cube(), decimals);
    const double rounding = largest_rounding(decimals);
    for (const bool has_faces : {false, true}) {
      Polyhedron cube = has_faces ? box({1, 1, 1}) : cloud_alone(corners);
      cube.vertices.assign(corners.begin(), corners.end());
      const FitReport report = fit_polyhedron(cube, 2 * rounding);
      REQUIRE(report.fault.fault == Fault::none);
      CHECK(cube.face_count() == 6);
      CHECK(cube.vertex_count() == 8);
      // The fit of four corners is nowhere farther off than their distance from the true plane summed up.
      CHECK(report.deviation <= 2 * rounding);
      // Three planes that meet at right angles, each off by the deviation and turned by twice of it.
      CHECK(report.moved <= 3 * std::sqrt(3.0) * report.deviation + 1e-15);
      for (int f = 0; f < 6; ++f)
        CHECK(std::abs(0.5 * area_vector(cube, f).norm() - 1) <= 8 * rounding + 1e-14);
    }
  }
}

TEST_CASE("two flush cubes written to a few decimals are flush after the fit") {
  const Cloud upper = written(tilted_cube(), 6);
  Cloud lower;
  const Vector<3> up = tilted_cube()[4] - tilted_cube()[0];
  for (const Vector<3>& corner : tilted_cube()) lower.push_back(corner - up);
  Polyhedron above = box({1, 1, 1}), below = box({1, 1, 1});
  above.vertices.assign(upper.begin(), upper.end());
  const Cloud rounded = written(lower, 6);
  below.vertices.assign(rounded.begin(), rounded.end());
  REQUIRE(fit_polyhedron(above, 2e-6).fault.fault == Fault::none);
  REQUIRE(fit_polyhedron(below, 2e-6).fault.fault == Fault::none);
  double nearest = HUGE_VAL;
  for (const Vector<3>& a : above.normals) {
    for (const Vector<3>& b : below.normals) nearest = std::min(nearest, (a + b).norm());
  }
  CHECK(nearest <= 4e-15);
}

TEST_CASE("a shape that is plane and convex to rounding does not move") {
  for (const PlatonicSolid& solid : platonic_solids()) {
    CAPTURE(solid.name);
    const Polyhedron exact = hull_of(solid.vertices);
    Polyhedron fitted = cloud_alone(solid.vertices);
    const FitReport report = fit_polyhedron(fitted, 0);
    REQUIRE(report.fault.fault == Fault::none);
    CHECK(report.merged == 0);
    CHECK(report.moved == 0);
    CHECK(fitted.vertices == exact.vertices);
    CHECK(fitted.normals == exact.normals);
  }
}

TEST_CASE("a dent up to the tolerance is taken, a deeper one named with the tolerance that would do") {
  Polyhedron taken = dented_cube(1e-3);
  const FitReport report = fit_polyhedron(taken, 1e-3);
  REQUIRE(report.fault.fault == Fault::none);
  CHECK(report.merged == 18);
  CHECK(taken.face_count() == 6);
  CHECK(report.moved == Approx(8e-4).epsilon(1e-3));  // the plane of five points, one of them 1e-3 below
  CHECK(shape_of(taken).volume() == Approx(1).epsilon(1e-3));

  Polyhedron refused = dented_cube(1e-2);
  const FitReport fault = fit_polyhedron(refused, 1e-3);
  REQUIRE(fault.fault.fault == Fault::beyond_tolerance);
  CHECK(refused.is_empty());
  CHECK(fault.deviation == Approx(1e-2).epsilon(1e-12));
  CHECK(fault.fault.vertex == 13);
  CHECK(fault.fault.face >= 20);
  // No plane leaves less than half of it; one fitted to the whole face leaves 8e-3. Trials are 1.05 apart, to
  // two digits.
  CHECK(fault.sufficient >= 5e-3);
  CHECK(fault.sufficient <= 8e-3 * 1.05 * 1.1);
  Polyhedron again = dented_cube(1e-2);
  CHECK(fit_polyhedron(again, fault.sufficient).fault.fault == Fault::none);
}

TEST_CASE("a vertex within an edge and loops turned inside are taken") {
  Polyhedron cube = dented_cube(0);
  std::reverse(cube.face_vertices.begin(), cube.face_vertices.end());  // all have three corners
  const FitReport report = fit_polyhedron(cube, 0);
  REQUIRE(report.fault.fault == Fault::none);
  CHECK(report.merged == 18);
  CHECK(shape_of(cube).volume() == Approx(1).epsilon(1e-15));

  // A square whose first side has a vertex in its middle, in the two faces there.
  Polyhedron split = faces_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}, {0.5, 0, 0}},
                              {{3, 2, 1, 5, 0}, {0, 5, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  REQUIRE(fit_polyhedron(split, 0).fault.fault == Fault::none);
  CHECK(split.vertex_count() == 5);
  CHECK(shape_of(split).volume() == Approx(1.0 / 3).epsilon(1e-15));
}

TEST_CASE("the fit scales with powers of two and follows a translation") {
  const Cloud corners = written(tilted_cube(), 4);
  Polyhedron one = cloud_alone(corners), scaled = cloud_alone(corners), moved = cloud_alone(corners);
  for (Vector<3>& v : scaled.vertices) v *= 0x1p-40;
  const Vector<3> shift(1e6, -2e6, 3e6);
  for (Vector<3>& v : moved.vertices) v += shift;
  const double tolerance = 2e-4;
  REQUIRE(fit_polyhedron(one, tolerance).fault.fault == Fault::none);
  REQUIRE(fit_polyhedron(scaled, 0x1p-40 * tolerance).fault.fault == Fault::none);
  REQUIRE(fit_polyhedron(moved, tolerance).fault.fault == Fault::none);
  REQUIRE(scaled.vertex_count() == one.vertex_count());
  for (std::size_t v = 0; v < 8; ++v) CHECK(scaled.vertices[v] == Vector<3>(0x1p-40 * one.vertices[v]));
  REQUIRE(moved.face_count() == 6);
  CHECK(shape_of(moved).volume() == Approx(shape_of(one).volume()).epsilon(1e-8));
}

TEST_CASE("a plane fitted to a long and narrow face keeps its digits") {
  const Vector<3> normal = Vector<3>(0.3, -0.5, 0.8).normalized();
  const Vector<3> along = cross_product(normal, Vector<3>(0, 1, 0)).normalized();
  const Vector<3> across = cross_product(normal, along);
  const Cloud points = {Vector<3>::Zero(), along, along + 1e-6 * across, 1e-6 * across, 0.5 * along};
  const FittedPlane fitted = fit_plane(points, normal + 0.05 * across + 0.05 * along);
  CHECK(fitted.deviation <= 1e-15);
  CHECK((fitted.plane.normal - normal).norm() <= 1e-9);  // rounding over the width
}

TEST_CASE("a prism of many sides is its outlines, whether its faces are whole or in triangles") {
  const int sides = GENERATE(63, 65, 2000);
  const bool is_in_triangles = GENERATE(false, true);
  CAPTURE(sides, is_in_triangles);
  Polyhedron prism(std::pmr::get_default_resource());
  for (const double z : {0.0, 1.0})
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * M_PI * i / sides;
      prism.vertices.push_back({std::cos(angle), std::sin(angle), z});
    }
  const auto add = [&](const std::vector<int>& loop) {
    for (std::size_t i = 1; is_in_triangles && i + 1 < loop.size(); ++i) {
      for (const int v : {loop[0], loop[i], loop[i + 1]}) prism.append_corner(v);
      prism.end_face();
    }
    if (is_in_triangles) return;
    for (const int v : loop) prism.append_corner(v);
    prism.end_face();
  };
  std::vector<int> lower, upper;
  for (int i = 0; i < sides; ++i) {
    lower.push_back(sides - 1 - i);
    upper.push_back(sides + i);
  }
  add(lower);
  add(upper);
  for (int i = 0; i < sides; ++i) add({i, (i + 1) % sides, sides + (i + 1) % sides, sides + i});
  const FitReport report = fit_polyhedron(prism, 0);
  REQUIRE(report.fault.fault == Fault::none);
  CHECK(report.moved == 0);
  CHECK(prism.face_count() == sides + 2);
  CHECK(prism.vertex_count() == 2 * sides);
  CHECK(check_polyhedron(prism).fault == Fault::none);
  const double area = 0.5 * sides * std::sin(2 * M_PI / sides);
  CHECK(shape_of(prism).volume() == Approx(area).epsilon(1e-12));
}

TEST_CASE("a tree of boxes finds the highest point that a scan finds") {
  Random random(7);
  const int count = GENERATE(1, 64, 65, 1000);
  Cloud points = random_cloud(random, count, GENERATE(0.0, 1.0), 1);
  for (std::size_t i = 0; i < points.size() / 2; ++i) points[i].z() = 1;  // many equals
  const SupportTree tree(points, std::pmr::get_default_resource());
  for (int trial = 0; trial < 100; ++trial) {
    const Vector<3> normal = trial == 0 ? Vector<3>(0, 0, 1) : random_direction(random);
    const auto height = [&](const Vector<3>& p) { return normal.dot(p) - 0.5; };
    HighestPoint wanted;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (height(points[i]) > wanted.height) wanted = {height(points[i]), std::int64_t(i)};
    const HighestPoint found = tree.highest(normal, -HUGE_VAL, height);
    CHECK(found.point == wanted.point);
    CHECK(found.height == wanted.height);
    if (wanted.height > 0) CHECK(tree.highest(normal, 0, height).point == wanted.point);
  }
}
