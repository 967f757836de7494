#include "extremes/contact_invariants.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"

namespace halfspace_test {
namespace {

constexpr double unit_roundoff = 0x1p-53;
constexpr double default_vertex_zone = 0.001;
constexpr double region_angle = 0.15;  // fifteen times the parallel angle

struct LongPoint {
  long double x, y;
};

std::vector<LongPoint> outline_of(const PlacedPolygon& p) {
  const long double z = p.pose.rotation[2], w = p.pose.rotation[3], d = z * z + w * w;
  const long double c = (w * w - z * z) / d, s = 2 * w * z / d;
  std::vector<LongPoint> outline;
  for (const Point& v : *p.vertices) {
    const long double x = (long double)v.x - p.centroid.x, y = (long double)v.y - p.centroid.y;
    outline.push_back({c * x - s * y + p.pose.position[0], s * x + c * y + p.pose.position[1]});
  }
  return outline;
}

long double distance_to_segment(LongPoint p, LongPoint a, LongPoint b) {
  const long double dx = b.x - a.x, dy = b.y - a.y;
  const long double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0L, 1.0L);
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// 0 inside.
long double distance_to_polygon(LongPoint p, const std::vector<LongPoint>& outline) {
  bool inside = true;
  long double least = HUGE_VALL;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const LongPoint a = outline[i], b = outline[(i + 1) % outline.size()];
    inside = inside && (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) >= 0;
    least = std::min(least, distance_to_segment(p, a, b));
  }
  return inside ? 0 : least;
}

double longest_edge(const Points& vertices) {
  double longest = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point p = vertices[i], q = vertices[(i + 1) % vertices.size()];
    longest = std::max(longest, std::hypot(p.x - q.x, p.y - q.y));
  }
  return longest;
}

double edge_length(const Scene& s, const hs_contact& c) {
  const EdgeAndVertex pair = edge_and_vertex(c);
  const Points& owner = pair.owner == 0 ? s.polygons.a : s.polygons.b;
  const Point p = owner[std::size_t(pair.edge)], q = owner[(std::size_t(pair.edge) + 1) % owner.size()];
  return std::hypot(p.x - q.x, p.y - q.y);
}

/// Where the gap is along the sum of two normals, the vertex may lie beside the end by the vertex zone.
double aside(const Scene& s, const hs_contact& c) {
  return c.type == HS_CONTACT_VERTEX_VERTEX ? default_vertex_zone * edge_length(s, c) : 0;
}

void check_indices(const Scene& s, const hs_contact& c) {
  const EdgeAndVertex pair = edge_and_vertex(c);
  const bool a_owns = pair.owner == 0;
  const std::size_t edges = (a_owns ? s.polygons.a : s.polygons.b).size();
  const std::size_t vertices = (a_owns ? s.polygons.b : s.polygons.a).size();
  CHECK((c.pair_kind == HS_PAIR_FACE_VERTEX || c.pair_kind == HS_PAIR_VERTEX_FACE));
  CHECK((pair.edge >= 0 && std::size_t(pair.edge) < edges));
  if (c.type == HS_CONTACT_NONE) {
    CHECK(pair.vertex == -1);
  } else {
    CHECK((pair.vertex >= 0 && std::size_t(pair.vertex) < vertices));
  }
  const int points = c.type == HS_CONTACT_NONE ? 0 : c.type == HS_CONTACT_EDGE_EDGE ? 2 : 1;
  CHECK(c.point_count == points);
  CHECK((c.block_a == 0 && c.block_b == 0 && c.reserved == 0));
}

}  // namespace

void check_invariants(const Scene& s, const hs_contact& c) {
  INFO(name_of(s.family) << " type " << c.type << " gap " << c.gap);
  check_indices(s, c);
  // Components by 6 roundings, turned twice by 10 each (exact_pair.h), so the square by twice that and its
  // own 3.
  const double length_squared = c.normal[0] * c.normal[0] + c.normal[1] * c.normal[1];
  CHECK(std::abs(length_squared - 1) <= 55 * unit_roundoff);
  CHECK(c.normal[2] == 0);
  CHECK(c.area >= 0);
  if (c.type == HS_CONTACT_EDGE_EDGE) {
    CHECK(c.area > 0);
    CHECK(c.area <= std::min(longest_edge(s.polygons.a), longest_edge(s.polygons.b)) * (1 + 1e-4));
  } else {
    CHECK(c.area == 0);
  }

  // Of unit thickness; and the centroid of one point or two.
  CHECK(c.length == c.area);
  if (c.point_count == 1) CHECK((c.center[0] == c.points[0][0] && c.center_gap == c.gaps[0]));
  if (c.point_count == 2) CHECK(c.center_gap == (c.gaps[0] + c.gaps[1]) / 2);

  const std::vector<LongPoint> a = outline_of(s.placed_a()), b = outline_of(s.placed_b());
  double magnitude = 0;
  for (const hs_pose& p : {s.poses.a, s.poses.b})
    magnitude += std::abs(p.position[0]) + std::abs(p.position[1]);
  const double rounding = unit_roundoff * (2 * rounding_bound * s.extent() + 2 * magnitude);
  for (int i = 0; i < c.point_count; ++i) {
    const LongPoint p{c.points[i][0], c.points[i][1]};
    const double reach = std::abs(c.gaps[i]) + aside(s, c) + rounding;
    CHECK(distance_to_polygon(p, a) <= reach);
    CHECK(distance_to_polygon(p, b) <= reach);
    CHECK(c.points[i][2] == 0);
  }
}

long double distance(const Scene& s) {
  // Seen from a, so that the distance from the origin costs no digits.
  PlacedPolygon placed_a = s.placed_a(), placed_b = s.placed_b();
  for (int i = 0; i < 2; ++i) {
    placed_b.pose.position[i] -= placed_a.pose.position[i];
    placed_a.pose.position[i] = 0;
  }
  const std::vector<LongPoint> a = outline_of(placed_a), b = outline_of(placed_b);
  long double least = HUGE_VALL;
  for (const LongPoint& p : a) least = std::min(least, distance_to_polygon(p, b));
  for (const LongPoint& p : b) least = std::min(least, distance_to_polygon(p, a));
  return least;
}

void check_least_depth(const Scene& s, const hs_contact& c) {
  const long double largest_gap = exact_verdict(s.placed_a(), s.placed_b()).largest_gap;
  const double bound = rounding_bound * unit_roundoff * s.extent();
  INFO(name_of(s.family) << " type " << c.type << " gap " << c.gap << " least depth "
                         << double(-largest_gap));
  if (!touches(c)) {
    CHECK(c.gap > 0);
    CHECK(c.gap <= largest_gap + bound);
    return;
  }
  CHECK(c.gap >= largest_gap - bound - aside(s, c));
  if (gap_is_of_the_pair(c)) CHECK(c.gap <= largest_gap + bound);
  if (c.type == HS_CONTACT_EDGE_EDGE) {
    // At an end of the region the depth is less than at the vertex by what the edges' angle makes of their
    // distance.
    CHECK(c.gap == std::min(c.gaps[0], c.gaps[1]));
    CHECK(c.gap <= largest_gap + std::tan(region_angle) * s.extent() + bound);
  }
}

TEST_CASE("every contact lies within its own depth of both blocks and is not deeper than they are") {
  long of_type[4] = {0, 0, 0, 0};
  for_each_scene(1500, 2000, [&](const Scene& s, Random&) {
    const hs_contact c = detect(s);
    ++of_type[c.type];
    check_invariants(s, c);
    check_least_depth(s, c);
  });
  std::printf("contacts looked at: none %ld, vertex-vertex %ld, vertex-edge %ld, edge-edge %ld\n", of_type[0],
              of_type[1], of_type[2], of_type[3]);
  for (long n : of_type) CHECK(n > 100);
}

}  // namespace halfspace_test
