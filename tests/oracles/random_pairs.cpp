#include "oracles/random_pairs.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "oracles/random_gap.h"

namespace halfspace_test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr double pi = 3.14159265358979323846;

/// Exact on the doubles given, so the result is strictly convex as it stands.
Points exact_hull(const Points& points) {
  std::vector<Kernel::Point_2> in;
  for (const Point& p : points) in.emplace_back(p.x, p.y);
  std::vector<Kernel::Point_2> out;
  CGAL::convex_hull_2(in.begin(), in.end(), std::back_inserter(out));
  Points hull;
  for (const auto& p : out) hull.push_back({p.x(), p.y()});
  return hull;
}

Points scaled_and_turned(Points points, double along, double across, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (Point& p : points) {
    const double x = along * p.x;
    const double y = across * p.y;
    p = {c * x - s * y, s * x + c * y};
  }
  return points;
}

Points triangle(Random& random) {
  Points points;
  for (int i = 0; i < 3; ++i)
    points.push_back({uniform_between(random, -1, 1), uniform_between(random, -1, 1)});
  return exact_hull(points);
}

Points random_box(Random& random) {
  const double w = uniform_between(random, 0.1, 1);
  const double h = uniform_between(random, 0.1, 1);
  return box(-w, -h, w, h);
}

Points regular(Random& random) {
  const int n = whole_between(random, 3, 40);
  const double phase = uniform_between(random, 0, 2 * pi);
  Points points;
  for (int i = 0; i < n; ++i)
    points.push_back({std::cos(phase + 2 * pi * i / n), std::sin(phase + 2 * pi * i / n)});
  return exact_hull(points);
}

Points random_hull(Random& random) {
  const int n = whole_between(random, 3, 40);
  Points points;
  for (int i = 0; i < n; ++i) {
    const double angle = uniform_between(random, 0, 2 * pi);
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  return scaled_and_turned(exact_hull(points), 1, uniform_between(random, 0.3, 1),
                           uniform_between(random, 0, 2 * pi));
}

Points sliver(Random& random) {
  return exact_hull(scaled_and_turned(random_hull(random), 1, 1e-6, uniform_between(random, 0, 2 * pi)));
}

/// A polygon with one corner cut off by an edge of length 1e-8.
Points with_short_edge(Random& random) {
  Points points = random_hull(random);
  const std::size_t n = points.size();
  const std::size_t corner = std::size_t(whole_between(random, 0, int(n) - 1));
  const Point here = points[corner];
  const auto towards = [&](const Point& p) {
    const double share = 0.7e-8 / std::hypot(p.x - here.x, p.y - here.y);
    return Point{here.x + share * (p.x - here.x), here.y + share * (p.y - here.y)};
  };
  const Point before = towards(points[(corner + n - 1) % n]);
  const Point after = towards(points[(corner + 1) % n]);
  points[corner] = before;
  points.insert(points.begin() + std::ptrdiff_t(corner) + 1, after);
  return exact_hull(points);
}

/// Boxes on a grid of 1/16 moved by (x, y): one on the other, a common side, no rounding anywhere.
PolygonPair stacked(double x, double y, Random& random) {
  const auto grid = [&](int from, int to) { return whole_between(random, from, to) / 16.0; };
  const double top = grid(1, 32);
  const double shift = grid(-32, 32);
  return {box(x - grid(1, 32), y - grid(1, 32), x + grid(1, 32), y + top),
          box(x + shift, y + top, x + shift + grid(1, 32), y + top + grid(1, 32))};
}

/// Two polygons on either side of a common edge, both with the same two vertices.
PolygonPair neighbours(Random& random) {
  const Point p{uniform_between(random, -1, 1), uniform_between(random, -1, 1)};
  const double angle = uniform_between(random, 0, 2 * pi);
  const double length = uniform_between(random, 0.1, 1);
  const Point q{p.x + length * std::cos(angle), p.y + length * std::sin(angle)};
  const auto beside = [&](double side) {
    Points points{p, q};
    const int more = whole_between(random, 1, 6);
    for (int i = 0; i < more; ++i) {
      const double along = uniform_between(random, 0, 1);
      const double away = side * uniform_between(random, 0.05, 1);
      points.push_back(
          {p.x + along * (q.x - p.x) - away * (q.y - p.y), p.y + along * (q.y - p.y) + away * (q.x - p.x)});
    }
    return exact_hull(points);
  };
  return {beside(1), beside(-1)};
}

/// A polygon with a vertex at `tip`, all of it within `spread` of the direction `heading`.
Points fan_from(Point tip, double heading, double spread, Random& random) {
  Points points{tip};
  const int more = whole_between(random, 2, 10);
  for (int k = 0; k < more; ++k) {
    const double angle = heading + uniform_between(random, -spread, spread);
    const double r = uniform_between(random, 0.1, 1);
    points.push_back({tip.x + r * std::cos(angle), tip.y + r * std::sin(angle)});
  }
  return exact_hull(points);
}

/// A vertex of b on an edge of a, as near as doubles allow.
PolygonPair vertex_on_edge(Random& random) {
  const Points a = random_hull(random);
  const std::size_t i = std::size_t(whole_between(random, 0, int(a.size()) - 1));
  const Point p = a[i];
  const Point q = a[(i + 1) % a.size()];
  const double t = whole_between(random, 0, 2) == 0 ? 0.5 : uniform_between(random, 0.01, 0.99);
  const Point on{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  return {a, fan_from(on, std::atan2(p.x - q.x, q.y - p.y), 1.4, random)};
}

/// A vertex of b at a vertex of a, exactly.
PolygonPair vertex_on_vertex(Random& random) {
  const Points a = random_hull(random);
  const std::size_t n = a.size();
  const std::size_t i = std::size_t(whole_between(random, 0, int(n) - 1));
  const Point before = a[(i + n - 1) % n], here = a[i], after = a[(i + 1) % n];
  const auto heading_of_normal = [](Point p, Point q) { return std::atan2(p.x - q.x, q.y - p.y); };
  const double from = heading_of_normal(before, here);
  const double turn = std::remainder(heading_of_normal(here, after) - from, 2 * pi);
  return {a, fan_from(here, from + 0.5 * turn, 0.7, random)};
}

hs_pose where_it_was_made(const hs_shape* shape) {
  const hs_shape_properties p = properties_of(shape);
  return pose_at(p.centroid[0], p.centroid[1]);
}

hs_pose turned_at_random(double x, double y, Random& random) {
  const double half = whole_between(random, 0, 3) == 0 ? 0 : uniform_between(random, -pi, pi);
  return pose_at(x, y, std::sin(half), std::cos(half));
}

Points local_and_turned(const Points& vertices, const hs_shape* shape, const hs_pose& pose) {
  const hs_shape_properties properties = properties_of(shape);
  Points local = vertices;
  for (Point& p : local) p = {p.x - properties.centroid[0], p.y - properties.centroid[1]};
  return scaled_and_turned(local, 1, 1, 2 * std::atan2(pose.rotation[2], pose.rotation[3]));
}

/// How far the centroids must be apart along `direction` (unit) so that the largest gap of all edges of `a`
/// against `b` is `gap`: the gap of each edge grows linearly with the distance.
double distance_for_gap(const Points& a, const Points& b, Point direction, double gap) {
  double distance = std::numeric_limits<double>::infinity();
  const auto add_edges_of = [&](const Points& owner, const Points& other, double sign) {
    for (std::size_t i = 0; i < owner.size(); ++i) {
      const Point p = owner[i];
      const Point q = owner[(i + 1) % owner.size()];
      const double length = std::hypot(q.x - p.x, q.y - p.y);
      const double nx = (q.y - p.y) / length;
      const double ny = -(q.x - p.x) / length;
      double deepest = std::numeric_limits<double>::infinity();
      for (const Point& v : other) deepest = std::min(deepest, nx * (v.x - p.x) + ny * (v.y - p.y));
      const double rate = sign * (nx * direction.x + ny * direction.y);
      if (rate > 0) distance = std::min(distance, (gap - deepest) / rate);
    }
  };
  add_edges_of(a, b, 1);
  add_edges_of(b, a, -1);
  return distance;
}

}  // namespace

const char* name_of(Family family) {
  switch (family) {
    case Family::triangles:
      return "triangles";
    case Family::boxes:
      return "boxes";
    case Family::regular:
      return "regular";
    case Family::random_hulls:
      return "random hulls";
    case Family::slivers:
      return "slivers 1e6";
    case Family::short_edges:
      return "edges of 1e-8";
    case Family::stacked_boxes:
      return "stacked boxes";
    case Family::stacked_far_away:
      return "stacked 1e8 away";
    case Family::shared_edge:
      return "shared edge";
    case Family::vertex_on_edge:
      return "vertex on edge";
    case Family::vertex_on_vertex:
      return "vertex on vertex";
    case Family::far_from_origin:
      return "1e8 away";
    case Family::size_ratio:
      return "size ratio 1e6";
  }
  return "";
}

bool is_placed_by_vertices(Family family) {
  return family == Family::stacked_boxes || family == Family::stacked_far_away ||
         family == Family::shared_edge || family == Family::vertex_on_edge ||
         family == Family::vertex_on_vertex;
}

PolygonPair draw_polygons(Family family, Random& random) {
  switch (family) {
    case Family::triangles:
      return {triangle(random), triangle(random)};
    case Family::boxes:
      return {random_box(random), random_box(random)};
    case Family::regular:
      return {regular(random), regular(random)};
    case Family::slivers:
      return {sliver(random), whole_between(random, 0, 1) ? sliver(random) : random_hull(random)};
    case Family::short_edges:
      return {with_short_edge(random), with_short_edge(random)};
    case Family::stacked_boxes:
      return stacked(0, 0, random);
    case Family::stacked_far_away:
      return stacked(1e8, -1e8, random);
    case Family::shared_edge:
      return neighbours(random);
    case Family::vertex_on_edge:
      return vertex_on_edge(random);
    case Family::vertex_on_vertex:
      return vertex_on_vertex(random);
    case Family::size_ratio:
      return {random_hull(random), scaled_and_turned(random_hull(random), 1e6, 1e6, 0)};
    case Family::random_hulls:
    case Family::far_from_origin:
      break;
  }
  return {random_hull(random), random_hull(random)};
}

PosePair draw_poses(Family family, const PolygonPair& polygons, const hs_shape* a, const hs_shape* b,
                    Random& random) {
  if (is_placed_by_vertices(family)) return {where_it_was_made(a), where_it_was_made(b)};

  const double reach = family == Family::far_from_origin ? 1e8 : 1;
  const Point origin{uniform_between(random, -reach, reach), uniform_between(random, -reach, reach)};
  const double angle = uniform_between(random, 0, 2 * pi);
  const Point direction{std::cos(angle), std::sin(angle)};
  const hs_pose pose_a = turned_at_random(origin.x, origin.y, random);
  hs_pose pose_b = turned_at_random(0, 0, random);

  const double size = std::min(properties_of(a).bounding_radius, properties_of(b).bounding_radius);
  // A sliver may be too thin for the gap wanted: then it lies centroid on centroid.
  const double distance = std::max(
      0.0, distance_for_gap(local_and_turned(polygons.a, a, pose_a), local_and_turned(polygons.b, b, pose_b),
                            direction, draw_gap(size, random)));
  pose_b.position[0] = origin.x + distance * direction.x;
  pose_b.position[1] = origin.y + distance * direction.y;
  return {pose_a, pose_b};
}

}  // namespace halfspace_test
