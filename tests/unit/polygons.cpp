#include "polygons.h"

#include <cmath>
#include <numbers>

#include "geometry/polygon/hull.h"

namespace halfspace::test {

std::uint64_t Random::next() {
  std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

double Random::uniform(double lower, double upper) {
  return lower + (upper - lower) * (double(next() >> 11) * 0x1p-53);
}

int Random::integer(int lower, int upper) { return lower + int(next() % std::uint64_t(upper - lower + 1)); }

Points regular_polygon(int count, double radius, double phase) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double angle = phase + 2 * std::numbers::pi * i / count;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

Points random_polygon(Random& random, int max_vertices, double radius) {
  Points points;
  const int count = random.integer(3, max_vertices);
  for (int i = 0; i < 2 * count; ++i) {
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    const double r = radius * random.uniform(0.7, 1);
    points.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  const Array<Vector<2>> hull = convex_hull(points, std::pmr::get_default_resource());
  return {hull.begin(), hull.end()};
}

Points rectangle(double width, double height, const Vector<2>& center) {
  const double x = width / 2, y = height / 2;
  return {center + Vector<2>(-x, -y), center + Vector<2>(x, -y), center + Vector<2>(x, y),
          center + Vector<2>(-x, y)};
}

Shape<2> shape_of(const Points& points) { return Shape<2>(points, std::pmr::get_default_resource()); }

}  // namespace halfspace::test
