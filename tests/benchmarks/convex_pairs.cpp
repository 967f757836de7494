#include "convex_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfspace_benchmark {
namespace {

Point round_to_float(Point p) { return {double(float(p.x)), double(float(p.y))}; }

Points draw_polygon(int vertices, Random& random) {
  Points polygon = random_polygon(vertices, size * uniform(random, 0.4, 0.6), random);
  std::transform(polygon.begin(), polygon.end(), polygon.begin(), round_to_float);
  return polygon;
}

Points lay(const Points& polygon, const Placement& at) {
  const double c = std::cos(at.angle), s = std::sin(at.angle);
  Points laid;
  for (const Point& p : polygon)
    laid.push_back({at.position.x + (c * p.x - s * p.y), at.position.y + (s * p.x + c * p.y)});
  return laid;
}

double largest_height_over_an_edge(const Points& owner, const Points& other) {
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < owner.size(); ++i) {
    const Point from = owner[i], to = owner[(i + 1) % owner.size()];
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const Point normal{(to.y - from.y) / length, (from.x - to.x) / length};
    double least = std::numeric_limits<double>::infinity();
    for (const Point& p : other)
      least = std::min(least, (p.x - from.x) * normal.x + (p.y - from.y) * normal.y);
    largest = std::max(largest, least);
  }
  return largest;
}

bool boxes_overlap(const Points& a, const Points& b) {
  const auto apart_along = [&](double Point::*axis) {
    const auto less = [&](const Point& p, const Point& q) { return p.*axis < q.*axis; };
    const auto [a_low, a_high] = std::minmax_element(a.begin(), a.end(), less);
    const auto [b_low, b_high] = std::minmax_element(b.begin(), b.end(), less);
    return (*a_high).*axis < (*b_low).*axis || (*b_high).*axis < (*a_low).*axis;
  };
  return !apart_along(&Point::x) && !apart_along(&Point::y);
}

/// Moves b away from a along a direction until they are apart by `wanted`. The separation is convex in the
/// distance, so that there is one such place if the polygons overlap more than that at the start.
bool lay_apart(const PairSet& set, ConvexPair& pair, double direction, double wanted) {
  const auto at = [&](double distance) {
    pair.at_b.position = {pair.at_a.position.x + distance * std::cos(direction),
                          pair.at_a.position.y + distance * std::sin(direction)};
    return separation(set, pair);
  };
  double too_near = 0, too_far = 3 * size;
  if (at(too_near) >= wanted) return false;
  for (int i = 0; i < 60; ++i) {
    const double middle = (too_near + too_far) / 2;
    (at(middle) < wanted ? too_near : too_far) = middle;
  }
  pair.at_b.position = round_to_float(pair.at_b.position);
  return true;
}

bool boxes_overlap(const PairSet& set, const ConvexPair& pair) {
  return boxes_overlap(lay(set.polygons[std::size_t(pair.a)], pair.at_a),
                       lay(set.polygons[std::size_t(pair.b)], pair.at_b));
}

ConvexPair draw_pair(const PairSet& set, double wanted, Random& random) {
  std::uniform_int_distribution<int> polygon(0, int(set.polygons.size()) - 1);
  for (;;) {
    ConvexPair pair{polygon(random), polygon(random), {}, {}};
    pair.at_a.position = round_to_float({size * uniform(random, -10, 10), size * uniform(random, -10, 10)});
    pair.at_a.angle = float(uniform(random, -pi, pi));
    pair.at_b.angle = float(uniform(random, -pi, pi));
    if (lay_apart(set, pair, uniform(random, -pi, pi), wanted) && boxes_overlap(set, pair)) return pair;
  }
}

}  // namespace

double separation(const Points& a, const Points& b) {
  return std::max(largest_height_over_an_edge(a, b), largest_height_over_an_edge(b, a));
}

double separation(const PairSet& set, const ConvexPair& pair) {
  return separation(lay(set.polygons[std::size_t(pair.a)], pair.at_a),
                    lay(set.polygons[std::size_t(pair.b)], pair.at_b));
}

PairSet draw_pairs(int pair_count, int polygon_count, int vertices, const GapSet& gap, Random& random) {
  PairSet set;
  for (int i = 0; i < polygon_count; ++i) set.polygons.push_back(draw_polygon(vertices, random));
  for (int i = 0; i < pair_count; ++i) set.pairs.push_back(draw_pair(set, gap.separation * size, random));
  return set;
}

}  // namespace halfspace_benchmark
