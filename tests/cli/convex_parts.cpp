#include "blocks/rock/convex_parts.h"

#include <limits>
#include <random>

#include "blocks/rock/outline.h"
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

/// Even-odd rule.
bool is_inside(const Polygon& polygon, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a[1] > p[1]) == (b[1] > p[1])) continue;
    if (a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) > p[0]) inside = !inside;
  }
  return inside;
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

TEST_CASE("an outline that touches or crosses itself is found with its place, in both orders") {
  const struct {
    Polygon outline;
    std::size_t vertex;
    std::string text;
  } cases[] = {
      {{{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}, 2, "touches vertex 5"},
      {{{0, 0}, {4, 0}, {4, 3}, {2, 0}, {0, 3}},
       3,
       "touches the edge from vertex 0 [0, 0] to vertex 1 [4, 0]"},
      {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}},
       0,
       "touches vertex 4"},
      {{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {1, 3}, {1, 2}, {0, 2}}, 5, "turns back"},
      {{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}, {0.5, 1}, {0, 1}}, 7, "turns back"},
      {{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, 0, "crosses the edge from vertex 2"},
      {{{0, 0}, {4, 0}, {4, 3}, {2, 1e-11}, {0, 3}}, 3, "touches the edge"},
  };
  for (const auto& [outline, vertex, text] : cases) {
    const auto found = find_self_contact(outline);
    REQUIRE(found);
    CHECK(found->vertex == vertex);
    CHECK(found->text.find(text) != std::string::npos);
    CHECK(find_self_contact({outline.rbegin(), outline.rend()}));
  }
  CHECK(!find_self_contact({{0, 0}, {1, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}));
}

/// On a small lattice many outlines touch themselves, corner on corner and corner on edge, and have straight
/// corners.
TEST_CASE("a random outline on a lattice is refused, or its parts cover its inside once") {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> place(0, 4);
  int divided = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    Polygon outline(4 + static_cast<std::size_t>(trial % 5));
    for (Point& corner : outline) corner = {double(place(random)), double(place(random))};
    bool is_repeated = false;
    for (std::size_t i = 0; i < outline.size(); ++i)
      is_repeated |= outline[i] == outline[(i + 1) % outline.size()];
    if (is_repeated || find_self_contact(outline)) continue;
    ++divided;
    const std::vector<Polygon> parts = convex_parts(outline);
    double sum = 0;
    for (const Polygon& part : parts) sum += area(part);
    CHECK(sum == Approx(std::abs(area(outline))).epsilon(1e-14));
    for (double x = 0.21; x < 4; x += 0.5) {
      for (double y = 0.23; y < 4; y += 0.5) {
        const Point point{x, y};
        const auto count = std::count_if(parts.begin(), parts.end(),
                                         [&](const Polygon& part) { return is_inside(part, point); });
        CHECK(count == is_inside(outline, point));
      }
    }
  }
  CHECK(divided > 1000);
}
