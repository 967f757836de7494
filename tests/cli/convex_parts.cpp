#include "blocks/rock/convex_parts.h"

#include <limits>
#include <random>

#include "catch.h"

using namespace halfspace::cli;

namespace {

using Polygon = std::vector<Point>;

double area(const Polygon& polygon) { return 0.5 * area_normal(polygon)[2]; }

double turn_at(const Polygon& polygon, std::size_t i) {
  const std::size_t n = polygon.size();
  return cross(minus(polygon[i], polygon[(i + n - 1) % n]), minus(polygon[(i + 1) % n], polygon[i]))[2];
}

/// The parts are convex and have the area of the whole.
void check(const Polygon& polygon, std::size_t most_parts) {
  const std::vector<Polygon> parts = convex_parts(polygon);
  double sum = 0;
  for (const Polygon& part : parts) {
    REQUIRE(part.size() >= 3);
    for (std::size_t i = 0; i < part.size(); ++i) CHECK(turn_at(part, i) > 0);
    sum += area(part);
  }
  const double rounding =
      std::numeric_limits<double>::epsilon() * static_cast<double>(polygon.size());  // of the sum
  CHECK(sum == Approx(std::abs(area(polygon))).epsilon(1e-14 + rounding));
  CHECK(parts.size() <= most_parts);
}

}  // namespace

TEST_CASE("a concave polygon is divided into few convex parts") {
  const Polygon l_shape = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
  check(l_shape, 2);
  check({l_shape.rbegin(), l_shape.rend()}, 2);  // clockwise
  check({{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 3);
  check({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
}

/// Each reflex corner takes at most two cuts.
TEST_CASE("random stars are divided into at most two parts more per reflex corner") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> radius(0.2, 1);
  for (int corners = 5; corners < 60; ++corners) {
    Polygon star;
    for (int i = 0; i < corners; ++i) {
      const double r = radius(random), angle = 6.283185307179586 * i / corners;
      star.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    std::size_t reflex = 0;
    for (std::size_t i = 0; i < star.size(); ++i) reflex += turn_at(star, i) < 0;
    check(star, 2 * reflex + 1);
  }
}

TEST_CASE("polygons of 20,000 corners are divided, with many reflex corners and with one") {
  constexpr int corners = 20000;
  const bool is_star = GENERATE(true, false);
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * i / corners, r = is_star ? 1 + 0.5 * (i % 2) : i == 7 ? 0.9 : 1;
    polygon.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  check(polygon, is_star ? corners / 2 + 1 : 3);
}
