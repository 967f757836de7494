#include "blocks/rock/voronoi.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <vector>

#include "catch.h"

using namespace halfspace::cli;

namespace {

// Coordinates below 8 and some 20 cuts of a few units of 2^-50 each, which where planes meet at small angles
// show some hundred times larger.
constexpr double rounding = 1e-11;

std::vector<Point> wedge() { return {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {0, 0, 5}, {4, 0, 5}, {0, 3, 5}}; }

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

Voronoi voronoi_of(std::int64_t count, std::int64_t relaxation = 0) {
  Voronoi voronoi;
  voronoi.count = count;
  voronoi.relaxation = relaxation;
  voronoi.seed = 11;
  return voronoi;
}

std::vector<double> volumes_of(const Context& context, const std::vector<Shape>& blocks) {
  std::vector<double> volumes;
  for (const Shape& block : blocks) volumes.push_back(properties_of(context, block).volume);
  return volumes;
}

/// Standard deviation over mean.
double unevenness(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / count) / mean;
}

}  // namespace

TEST_CASE("Voronoi blocks fill a convex region, each around its own site") {
  const Context context = make_context();
  const auto count = GENERATE(std::int64_t{2}, std::int64_t{3}, std::int64_t{300});
  const Voronoi voronoi = voronoi_of(count);
  const Shape region = make_hull(context, wedge());
  const std::vector<Point> sites = random_sites(context, region, count, voronoi.seed);
  const std::vector<Shape> blocks = voronoi_blocks(context, voronoi, region);
  REQUIRE(blocks.size() == static_cast<std::size_t>(count));

  const std::vector<double> volumes = volumes_of(context, blocks);
  const double sum = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  // The wedge has 30 m3, its cells together some 600 m2 of faces.
  CHECK(std::abs(sum - 30) < 600 * rounding);

  // By definition: no site is nearer to a corner of a block than the block's own.
  double worst = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (const Point& corner : vertices_of(context, blocks[i])) {
      double nearest = INFINITY;
      for (const Point& site : sites) nearest = std::min(nearest, distance(corner, site));
      worst = std::max(worst, distance(corner, sites[i]) - nearest);
    }
  }
  std::cout << count << " blocks, volume off by " << std::abs(sum - 30)
            << " m3; a corner is nearer to another site by " << worst << " m, allowed " << rounding << '\n';
  CHECK(worst < rounding);
}

TEST_CASE("sites are inside the region, and decided by the seed") {
  const Context context = make_context();
  const Shape region = make_hull(context, wedge());
  const std::vector<Point> sites = random_sites(context, region, 1000, 3);
  CHECK(sites == random_sites(context, region, 1000, 3));
  CHECK(sites != random_sites(context, region, 1000, 4));
  int in_lower_half = 0;
  for (const Point& site : sites) {
    CHECK((site[0] > 0 && site[1] > 0 && site[0] / 4 + site[1] / 3 < 1 && site[2] > 0 && site[2] < 5));
    in_lower_half += site[2] < 2.5;
  }
  // 1000 fair coins: six standard deviations of 16.
  CHECK(std::abs(in_lower_half - 500) < 96);
}

TEST_CASE("being neighbours is mutual, at any scale and place") {
  const Context context = make_context();
  const Shape region = make_hull(context, wedge());
  std::vector<Point> sites = random_sites(context, region, 200, 5);
  const std::vector<std::vector<int>> neighbours = neighbouring_sites(sites, wedge());
  std::size_t sum = 0;
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    sum += neighbours[i].size();
    for (int j : neighbours[i]) {
      const std::vector<int>& others = neighbours[static_cast<std::size_t>(j)];
      CHECK(std::binary_search(others.begin(), others.end(), static_cast<int>(i)));
    }
  }
  CHECK(sum / neighbours.size() >= 8);  // some 15 far from the border, fewer along it
  std::vector<Point> around = wedge();
  for (std::vector<Point>* points : {&sites, &around}) {
    for (Point& p : *points) {
      for (double& coordinate : p) coordinate *= 0x1p-40;
    }
  }
  CHECK(neighbouring_sites(sites, around) == neighbours);
}

TEST_CASE("relaxation makes blocks more alike") {
  const Context context = make_context();
  const Shape region = make_hull(context, wedge());
  const double raw = unevenness(volumes_of(context, voronoi_blocks(context, voronoi_of(100), region)));
  const std::vector<double> relaxed =
      volumes_of(context, voronoi_blocks(context, voronoi_of(100, 10), region));
  std::cout << "volumes deviate by " << raw << " of their mean, after relaxation by " << unevenness(relaxed)
            << '\n';
  CHECK(unevenness(relaxed) < raw / 2);
  CHECK(std::abs(std::accumulate(relaxed.begin(), relaxed.end(), 0.0) - 30) < 600 * rounding);
}
