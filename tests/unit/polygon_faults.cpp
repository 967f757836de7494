#include <algorithm>
#include <limits>

#include "catch.h"
#include "geometry/polygon_check.h"
#include "geometry/polygon_clean.h"
#include "polygons.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

void expect_fault(const Points& points, Fault fault, std::int64_t vertex) {
  const FaultReport report = check_polygon(points);
  CHECK(int(report.fault) == int(fault));
  CHECK(report.vertex == vertex);
}

}  // namespace

TEST_CASE("each fault of a polygon is named with its vertex") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  expect_fault({{0, 0}, {1, 0}}, Fault::too_few_vertices, -1);
  expect_fault({{0, 0}, {1, 0}, {0, nan}}, Fault::not_finite, 2);
  expect_fault({{0, 0}, {infinity, 0}, {0, 1}}, Fault::not_finite, 1);
  expect_fault({{0, 0}, {1, 0}, {1, 0}, {0, 1}}, Fault::repeated_vertex, 2);
  expect_fault({{0, 0}, {1, 0}, {0, 1}, {0, 0}}, Fault::repeated_vertex, 0);
  expect_fault({{0, 0}, {1, 0}, {2, 0}, {0, 1}}, Fault::collinear_vertex, 1);
  expect_fault({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}, Fault::not_convex, 2);
  expect_fault({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, Fault::self_crossing, -1);
  expect_fault({{0, 0}, {1, 1}, {2, 2}}, Fault::zero_area, -1);
}

TEST_CASE("an outline that winds twice is self-crossing although it turns one way only") {
  Points pentagram;
  const Points pentagon = regular_polygon(5, 1);
  for (std::size_t i = 0; i < 5; ++i) pentagram.push_back(pentagon[(2 * i) % 5]);
  CHECK(check_polygon(pentagram).fault == Fault::self_crossing);
}

TEST_CASE("either order, any count, small edges and small angles are legal") {
  Points square = rectangle(1, 1);
  CHECK(check_polygon(square).fault == Fault::none);
  std::reverse(square.begin(), square.end());
  CHECK(check_polygon(square).fault == Fault::none);
  CHECK(check_polygon(regular_polygon(1000, 1)).fault == Fault::none);
  CHECK(check_polygon(Points{{0, 0}, {1, 0}, {1, 1e-9}, {0.5, 1}}).fault == Fault::none);
  CHECK(check_polygon(Points{{0, 0}, {1, -1e-9}, {2, 0}, {1, 1}}).fault == Fault::none);
}

TEST_CASE("cleaning drops what it reports and moves nothing") {
  const Points found = {{0, 1}, {0, 0.5}, {0, 0}, {0, 1e-9}, {1, 0}, {1, 1}, {0, 1}};
  // Given clockwise or not, welded: (0, 1e-9) and the repeated (0, 1); straightened: (0, 0.5).
  CleanReport report;
  const Array<Vector<2>> kept = clean_polygon(found, 1e-6, report, std::pmr::get_default_resource());
  CHECK(report.welded == 2);
  CHECK(report.straightened == 1);
  CHECK_FALSE(report.reversed);
  CHECK(kept.size() == 4);
  for (const Vector<2>& v : kept) CHECK(std::find(found.begin(), found.end(), v) != found.end());
  CHECK(check_polygon(kept).fault == Fault::none);
}
