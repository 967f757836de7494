#include "benchmarks/convex_pairs_3d.h"

#include <algorithm>
#include <limits>

#include "oracles/minkowski_facets.h"

namespace halfspace_benchmark {
namespace {

using halfspace_test::PlacedPolyhedron;
using halfspace_test::Point3;
using halfspace_test::Points3;
using halfspace_test::uniform_between;

Polyhedron draw_polyhedron(int vertices, Random& random) {
  if (vertices != 8)
    return halfspace_test::round_polyhedron(vertices, size_3d * uniform_between(random, 0.4, 0.6), random);
  const Point3 half{size_3d * uniform_between(random, 0.2, 0.4), size_3d * uniform_between(random, 0.2, 0.4),
                    size_3d * uniform_between(random, 0.2, 0.4)};
  return halfspace_test::box_3d(-1.0 * half, half);
}

struct Bounds {
  Point3 low;
  Point3 high;
};

Bounds bounds_of(const PlacedPolyhedron& placed) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Bounds bounds{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  const double* position = placed.pose.position;
  for (const Point3& v : halfspace_test::local_vertices(*placed.polyhedron)) {
    const Point3 p = Point3{position[0], position[1], position[2]} + halfspace_test::turned(placed.pose, v);
    bounds.low = {std::min(bounds.low.x, p.x), std::min(bounds.low.y, p.y), std::min(bounds.low.z, p.z)};
    bounds.high = {std::max(bounds.high.x, p.x), std::max(bounds.high.y, p.y), std::max(bounds.high.z, p.z)};
  }
  return bounds;
}

bool boxes_overlap(const PlacedPolyhedron& a, const PlacedPolyhedron& b) {
  const Bounds of_a = bounds_of(a), of_b = bounds_of(b);
  const auto overlap_along = [&](double Point3::*axis) {
    return of_a.low.*axis <= of_b.high.*axis && of_b.low.*axis <= of_a.high.*axis;
  };
  return overlap_along(&Point3::x) && overlap_along(&Point3::y) && overlap_along(&Point3::z);
}

PolyhedraAt draw_pair(const PairSet3& set, double wanted, Random& random) {
  std::uniform_int_distribution<int> polyhedron(0, int(set.polyhedra.size()) - 1);
  for (;;) {
    PolyhedraAt pair;
    pair.a = polyhedron(random);
    pair.b = polyhedron(random);
    const Point3 place{size_3d * uniform_between(random, -10, 10), size_3d * uniform_between(random, -10, 10),
                       size_3d * uniform_between(random, -10, 10)};
    PlacedPolyhedron a{&set.polyhedra[std::size_t(pair.a)], halfspace_test::turned_at_random(place, random)};
    PlacedPolyhedron b{&set.polyhedra[std::size_t(pair.b)], halfspace_test::turned_at_random(place, random)};
    const halfspace_test::MinkowskiFacets facets(a, b);
    if (facets.separation({}).gap >= wanted) continue;
    const Point3 direction = halfspace_test::random_direction(random);
    const Point3 to_b =
        halfspace_test::turned(a.pose, facets.distance_for({}, direction, wanted) * direction);
    b.pose.position[0] += to_b.x;
    b.pose.position[1] += to_b.y;
    b.pose.position[2] += to_b.z;
    if (!boxes_overlap(a, b)) continue;
    pair.at_a = a.pose;
    pair.at_b = b.pose;
    return pair;
  }
}

}  // namespace

PairSet3 draw_pairs_3d(int pair_count, int polyhedron_count, int vertices, const GapSet& gap,
                       Random& random) {
  PairSet3 set;
  for (int i = 0; i < polyhedron_count; ++i) set.polyhedra.push_back(draw_polyhedron(vertices, random));
  for (int i = 0; i < pair_count; ++i) set.pairs.push_back(draw_pair(set, gap.separation * size_3d, random));
  return set;
}

}  // namespace halfspace_benchmark
