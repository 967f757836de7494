// Legal polygons, and how others are made so. Faults are named in tests/capi/shape.cpp.

#include <algorithm>

#include "catch.h"
#include "geometry/polygon/check.h"
#include "geometry/polygon/clean.h"
#include "polygons.h"

using namespace halfspace;
using namespace halfspace::test;

TEST_CASE("either order, any count, small edges and small angles are legal") {
  Points square = rectangle(1, 1);
  CHECK(check_polygon(square).fault == Fault::none);
  std::reverse(square.begin(), square.end());
  CHECK(check_polygon(square).fault == Fault::none);
  CHECK(check_polygon(regular_polygon(1000, 1)).fault == Fault::none);
  CHECK(check_polygon(Points{{0, 0}, {1, 0}, {1, 1e-9}, {0.5, 1}}).fault == Fault::none);
  CHECK(check_polygon(Points{{0, 0}, {1, -1e-9}, {2, 0}, {1, 1}}).fault == Fault::none);
}

TEST_CASE("an edge whose normal is lost among the least numbers is told") {
  for (const double tiny : {5e-324, 1e-310, 1e-293}) {
    const FaultReport report = check_polygon(Points{{0, 0}, {1, 0}, {1, 1}, {0, tiny}});
    CHECK(report.fault == Fault::not_finite);
    CHECK(report.vertex == 0);
  }
  CHECK(check_polygon(Points{{0, 0}, {1, 0}, {1, 1}, {0, 1e-291}}).fault == Fault::none);
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
