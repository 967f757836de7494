#include "blocks/rock/triangulation.h"

#include <iostream>
#include <map>
#include <utility>

#include "catch.h"

using namespace halfspace::cli;

namespace {

double area(const Triangle& t) {
  return ((t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[1][1] - t[0][1]) * (t[2][0] - t[0][0])) / 2;
}

Triangulated rectangle(double width, double height, std::int64_t count, double jitter) {
  Triangulated region;
  region.lower_left = {-width / 2, 0};
  region.upper_right = {width / 2, height};
  region.count = count;
  region.jitter = jitter;
  region.seed = 5;
  return region;
}

bool on_border(Point a, Point b, const Triangulated& region) {
  for (int axis : {0, 1}) {
    for (double side : {region.lower_left[axis], region.upper_right[axis]}) {
      if (a[axis] == side && b[axis] == side) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("a rectangle is cut into exactly the wanted number of triangles") {
  const auto count = GENERATE(std::int64_t{2}, std::int64_t{4}, std::int64_t{10}, std::int64_t{14},
                              std::int64_t{360}, std::int64_t{5788});
  const double width = GENERATE(0.01, 1.0, 300.0);
  const Triangulated region = rectangle(width, 1.2, count, 0.24);
  const std::vector<Triangle> triangles = triangulate(region);
  CHECK(static_cast<std::int64_t>(triangles.size()) == count);

  double sum = 0;
  std::map<std::pair<Point, Point>, int> edges;
  for (const Triangle& t : triangles) {
    REQUIRE(area(t) > 0);
    sum += area(t);
    for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  }
  // Relative rounding: a node is off by 2^-53 of the rectangle's size, a triangle by some 8 times that, and
  // the sum by count * 2^-53 more.
  CHECK(std::abs(sum - width * 1.2) <= width * 1.2 * static_cast<double>(count) * 16 * 0x1p-53);
  for (const auto& [edge, uses] : edges) {
    REQUIRE(uses == 1);
    const bool has_neighbour = edges.contains({edge.second, edge.first});
    REQUIRE(has_neighbour != on_border(edge.first, edge.second, region));
  }
}

TEST_CASE("the grains of the angle of repose have the size of the paper's") {
  const std::vector<Triangle> triangles = triangulate(rectangle(1.0, 1.2, 5788, 0.2));
  double edge_sum = 0;
  double least = 1;
  for (const Triangle& t : triangles) {
    least = std::min(least, area(t));
    for (int i = 0; i < 3; ++i)
      edge_sum += std::hypot(t[i][0] - t[(i + 1) % 3][0], t[i][1] - t[(i + 1) % 3][1]);
  }
  const double mean_edge = edge_sum / (3 * 5788);
  std::cout << "mean edge " << mean_edge << " m, smallest area " << least << " m2\n";
  // "about 0.02 m" (Wang et al. 2021, section 4.4): right-angled halves of squares of the same area have legs
  // of 0.0204 m and a mean edge of 0.0232 m; jitter lengthens edges by some hundredths.
  CHECK(mean_edge > 0.02);
  CHECK(mean_edge < 0.025);
}

TEST_CASE("the seed decides the triangles") {
  Triangulated region = rectangle(1, 1, 100, 0.2);
  const std::vector<Triangle> once = triangulate(region);
  CHECK(triangulate(region) == once);
  region.seed = 6;
  CHECK(triangulate(region) != once);
}
