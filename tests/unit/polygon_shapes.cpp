#include <numbers>

#include "catch.h"
#include "geometry/polygon/check.h"
#include "geometry/polygon/cut.h"
#include "geometry/polygon/hull.h"
#include "polygons.h"

using namespace halfspace;
using namespace halfspace::test;

TEST_CASE("moments of a rectangle are the textbook's, far from the origin too") {
  for (double away : {0.0, 1e8}) {
    const Shape<2> shape = shape_of(rectangle(4, 2, {away, -away}));
    CHECK(shape.area() == 8);
    CHECK(shape.centroid() == Vector<2>(away, -away));
    CHECK(shape.second_moment()[0] == Approx(4 * 4 * 4 * 2 / 12.0).epsilon(1e-15));
    CHECK(shape.second_moment()[1] == Approx(4 * 2 * 2 * 2 / 12.0).epsilon(1e-15));
    CHECK(std::abs(shape.second_moment()[2]) < 1e-15);
  }
}

TEST_CASE("moments of a regular polygon follow its closed form") {
  // Area n/2 sin(2 pi/n), polar moment A (2 + cos(2 pi/n)) / 6, for circumradius 1.
  const int n = GENERATE(3, 5, 8, 100);
  const double turn = 2 * std::numbers::pi / n;
  const Shape<2> shape = shape_of(regular_polygon(n, 1));
  const double area = 0.5 * n * std::sin(turn);
  // Each vertex carries an ulp of rounding, and n triangles are summed.
  CHECK(shape.area() == Approx(area).epsilon(n * 1e-15));
  CHECK(shape.polar_moment() == Approx(area * (2 + std::cos(turn)) / 6).epsilon(n * 1e-15));
  CHECK(shape.bounding_radius() == Approx(1).epsilon(1e-14));
}

TEST_CASE("every vertex is inside every half-space and on those of its own edges") {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const Shape<2> shape = shape_of(random_polygon(random, 30, 1));
    const Outline<2> o = shape.outline();
    for (int e = 0; e < o.count; ++e) {
      CHECK(o.normal(e).norm() == Approx(1).epsilon(1e-15));
      for (int v = 0; v < o.count; ++v) {
        const double height = o.normal(e).dot(o.vertex(v)) - o.offset[e];
        const bool on_edge = v == e || v == o.next(e);
        if (on_edge) CHECK(std::abs(height) < 1e-15);
        if (!on_edge) CHECK(height < 0);
      }
    }
  }
}

TEST_CASE("a hull holds all its points and is a valid polygon") {
  Random random(2);
  for (int round = 0; round < 200; ++round) {
    Points points;
    for (int i = random.integer(3, 60); i > 0; --i)
      points.push_back({random.uniform(-1, 1), random.uniform(-1, 1)});
    const Array<Vector<2>> hull = convex_hull(points, std::pmr::get_default_resource());
    REQUIRE(check_polygon(hull).fault == Fault::none);
    for (std::size_t e = 0; e < hull.size(); ++e) {
      const Vector<2> edge = hull[(e + 1) % hull.size()] - hull[e];
      for (const Vector<2>& p : points) CHECK(cross(edge, p - hull[e]) >= -1e-15);
    }
  }
}

TEST_CASE("points on one line have no hull") {
  const Array<Vector<2>> hull =
      convex_hull(Points{{0, 0}, {1, 2}, {2, 4}, {3, 6}}, std::pmr::get_default_resource());
  CHECK(hull.size() < 3);
}

TEST_CASE("the parts of a cut make up the whole and share their new vertices") {
  Random random(3);
  for (int round = 0; round < 500; ++round) {
    const Points whole = random_polygon(random, 20, 1);
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    const Vector<2> normal(std::cos(angle), std::sin(angle));
    const Vector<2> point = {random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6)};
    const PolygonParts parts = cut_polygon(whole, point, normal, std::pmr::get_default_resource());
    double area = 0;
    for (const auto* part : {&parts.behind, &parts.ahead}) {
      if (part->empty()) continue;
      REQUIRE(check_polygon(*part).fault == Fault::none);
      area += Shape<2>(*part, std::pmr::get_default_resource()).area();
    }
    // A new corner is off its line by an ulp or two of a unit coordinate.
    CHECK(area == Approx(shape_of(whole).area()).epsilon(1e-14));
    if (parts.behind.empty() || parts.ahead.empty()) continue;
    int shared = 0;
    for (const Vector<2>& p : parts.behind) {
      for (const Vector<2>& q : parts.ahead) shared += p == q;
    }
    CHECK(shared == 2);
  }
}

TEST_CASE("a line along an edge cuts nothing off") {
  const PolygonParts parts = cut_polygon(rectangle(2, 2), {0, 1}, {0, 1}, std::pmr::get_default_resource());
  CHECK(parts.ahead.empty());
  CHECK(parts.behind.size() == 4);
}

TEST_CASE("a polygon that is on a line to rounding is on neither side") {
  const PolygonParts parts =
      cut_polygon(rectangle(1, 1), {1e15, 0}, {0, 1}, std::pmr::get_default_resource());
  CHECK(!parts.is_cut());
}
