#include "oracles/random_pairs_3d.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "oracles/minkowski_facets.h"

namespace halfspace_test {
namespace {

/// The hull of what `draw` returns, drawn again if that is flat.
template <class Draw>
Polyhedron solid_hull(Draw draw) {
  for (;;) {
    const Polyhedron hull = convex_hull(draw());
    if (!hull.faces.empty()) return hull;
  }
}

Polyhedron tetrahedron(Random3& random) {
  return solid_hull([&] {
    Points3 points;
    for (int i = 0; i < 4; ++i) {
      const double radius = uniform_between(random, 0.3, 1);
      points.push_back(radius * random_direction(random));
    }
    return points;
  });
}

Polyhedron random_box(Random3& random) {
  const Point3 half{uniform_between(random, 0.1, 1), uniform_between(random, 0.1, 1),
                    uniform_between(random, 0.1, 1)};
  return box_3d(-1.0 * half, half);
}

Points3 random_points(int count, Random3& random) {
  Points3 points;
  for (int i = 0; i < count; ++i) points.push_back(random_direction(random));
  return points;
}

Polyhedron random_hull(Random3& random) {
  return convex_hull(random_points(whole_between(random, 5, 32), random));
}

/// A million times as long as thick: a plate or a needle, at any angle to the axes.
Polyhedron sliver(Random3& random) {
  return solid_hull([&] {
    Points3 points = random_points(whole_between(random, 4, 32), random);
    const double width = whole_between(random, 0, 1) ? 1 : 1e-6;
    const hs_pose any_turn = turned_at_random({}, random);
    for (Point3& p : points) p = turned(any_turn, {p.x, width * p.y, 1e-6 * p.z});
    return points;
  });
}

/// One vertex replaced by one on each of its edges, 1e-8 away.
Polyhedron with_short_edges(Random3& random) {
  const Polyhedron whole_one = random_hull(random);
  const int corner = whole_between(random, 0, int(whole_one.vertices.size()) - 1);
  return solid_hull([&] {
    Points3 points;
    for (std::size_t i = 0; i < whole_one.vertices.size(); ++i) {
      if (int(i) != corner) points.push_back(whole_one.vertices[i]);
    }
    const Point3 here = whole_one.vertices[std::size_t(corner)];
    for (const Polyhedron::Edge& edge : whole_one.edges) {
      if (edge.from != corner && edge.to != corner) continue;
      const Point3 there = whole_one.vertices[std::size_t(edge.from == corner ? edge.to : edge.from)];
      points.push_back(here + 1e-8 * unit(there - here));
    }
    return points;
  });
}

/// Boxes on a grid of 1/16 about a place, one on the other, with no rounding anywhere.
PolyhedronPair stacked(double place, Random3& random) {
  const auto grid = [&](int from, int to) { return whole_between(random, from, to) / 16.0; };
  const Point3 low{place - grid(1, 32), place - grid(1, 32), place - grid(1, 32)};
  const Point3 high{place + grid(1, 32), place + grid(1, 32), place + grid(1, 32)};
  const Point3 low_on_it{place + grid(-32, 32), place + grid(-32, 32), high.z};
  const Point3 size{grid(1, 32), grid(1, 32), grid(1, 32)};
  return {box_3d(low, high), box_3d(low_on_it, low_on_it + size)};
}

/// A fan of points from some that it keeps, all of them within an angle of `heading`, whose cosine is given.
Polyhedron fan_from(const Points3& kept, const Point3& heading, double least_cosine, Random3& random) {
  return solid_hull([&] {
    Points3 points = kept;
    const int more = whole_between(random, 3, 12);
    while (int(points.size()) < more + int(kept.size())) {
      const Point3 direction = random_direction(random);
      if (dot(direction, heading) >= least_cosine)
        points.push_back(kept[0] + uniform_between(random, 0.1, 1) * direction);
    }
    return points;
  });
}

Point3 normal_of_face(const Polyhedron& p, std::size_t face) {
  const Corner corner = widest_corner(p, p.faces[face]);
  const Point3 here = p.vertices[std::size_t(corner.here)];
  return unit(
      cross(here - p.vertices[std::size_t(corner.before)], p.vertices[std::size_t(corner.after)] - here));
}

/// Two polyhedra on either side of a triangle that is a face of both.
PolyhedronPair neighbours(Random3& random) {
  const Points3 triangle = random_points(3, random);
  const Point3 normal = unit(cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
  return {fan_from(triangle, -1.0 * normal, 0.1, random), fan_from(triangle, normal, 0.1, random)};
}

/// A vertex of b on a face of a, as near as doubles allow.
PolyhedronPair vertex_on_face(Random3& random) {
  const Polyhedron a = random_hull(random);
  const std::size_t f = std::size_t(whole_between(random, 0, int(a.faces.size()) - 1));
  Point3 on_face{};
  double sum = 0;
  for (const int v : a.faces[f]) {
    const double weight = uniform_between(random, 0.1, 1);
    on_face = on_face + weight * a.vertices[std::size_t(v)];
    sum += weight;
  }
  return {a, fan_from({(1 / sum) * on_face}, normal_of_face(a, f), 0.15, random)};
}

/// An edge of b across an edge of a, as near as doubles allow.
PolyhedronPair edge_on_edge(Random3& random) {
  const Polyhedron a = random_hull(random);
  const Polyhedron::Edge edge = a.edges[std::size_t(whole_between(random, 0, int(a.edges.size()) - 1))];
  const Point3 from = a.vertices[std::size_t(edge.from)], to = a.vertices[std::size_t(edge.to)];
  const Point3 crossing = from + uniform_between(random, 0.1, 0.9) * (to - from);
  const Point3 outward =
      unit(normal_of_face(a, std::size_t(edge.left)) + normal_of_face(a, std::size_t(edge.right)));
  const Point3 along = unit(cross(outward, to - from) + uniform_between(random, -0.5, 0.5) * (to - from));
  return {a, fan_from({crossing + uniform_between(random, 0.1, 1) * along,
                       crossing - uniform_between(random, 0.1, 1) * along},
                      outward, 0.15, random)};
}

/// A vertex of b at a vertex of a, exactly.
PolyhedronPair vertex_on_vertex(Random3& random) {
  const Polyhedron a = random_hull(random);
  const int vertex = whole_between(random, 0, int(a.vertices.size()) - 1);
  Point3 outward{};
  for (std::size_t f = 0; f < a.faces.size(); ++f) {
    if (std::count(a.faces[f].begin(), a.faces[f].end(), vertex)) outward = outward + normal_of_face(a, f);
  }
  return {a, fan_from({a.vertices[std::size_t(vertex)]}, unit(outward), 0.6, random)};
}

Polyhedron times(double factor, Polyhedron p) {
  for (Point3& v : p.vertices) v = factor * v;
  p = convex_hull(p.vertices);
  return p;
}

hs_pose where_it_was_made(const Polyhedron& p) {
  return {{p.centre.x, p.centre.y, p.centre.z}, {0, 0, 0, 1}};
}

double radius(const Polyhedron& p) {
  double most = 0;
  for (const Point3& v : p.vertices) most = std::max(most, length(v - p.centre));
  return most;
}

/// A pose followed by a turn about an axis of the turned frame, by an angle whose square is below rounding.
hs_pose turned_a_little(const hs_pose& pose, const Point3& axis, double angle) {
  const auto& [x, y, z, w] = pose.rotation;
  const Point3 half = (angle / 2) * axis;
  hs_pose turned = pose;
  turned.rotation[0] = x + (w * half.x + y * half.z - z * half.y);
  turned.rotation[1] = y + (w * half.y + z * half.x - x * half.z);
  turned.rotation[2] = z + (w * half.z + x * half.y - y * half.x);
  turned.rotation[3] = w - (x * half.x + y * half.y + z * half.z);
  return turned;
}

}  // namespace

bool is_placed_by_vertices(Family3 family) {
  switch (family) {
    case Family3::stacked_boxes:
    case Family3::stacked_far_away:
    case Family3::shared_face:
    case Family3::vertex_on_face:
    case Family3::edge_on_edge:
    case Family3::vertex_on_vertex:
      return true;
    default:
      return false;
  }
}

PolyhedronPair draw_polyhedra(Family3 family, Random3& random) {
  switch (family) {
    case Family3::tetrahedra:
      return {tetrahedron(random), tetrahedron(random)};
    case Family3::boxes:
    case Family3::nearly_parallel_faces:
      return {random_box(random), random_box(random)};
    case Family3::hulls_12:
      return {round_polyhedron(12, 1, random), round_polyhedron(12, 1, random)};
    case Family3::hulls_32:
      return {round_polyhedron(32, 1, random), round_polyhedron(32, 1, random)};
    case Family3::hulls_128:
      return {round_polyhedron(128, 1, random), round_polyhedron(128, 1, random)};
    case Family3::slivers:
      return {sliver(random), whole_between(random, 0, 1) ? sliver(random) : random_hull(random)};
    case Family3::short_edges:
      return {with_short_edges(random), with_short_edges(random)};
    case Family3::stacked_boxes:
      return stacked(0, random);
    case Family3::stacked_far_away:
      return stacked(1e8, random);
    case Family3::shared_face:
      return neighbours(random);
    case Family3::vertex_on_face:
      return vertex_on_face(random);
    case Family3::edge_on_edge:
      return edge_on_edge(random);
    case Family3::vertex_on_vertex:
      return vertex_on_vertex(random);
    case Family3::far_from_origin:
      return {random_hull(random), random_hull(random)};
    case Family3::size_ratio:
      return {random_hull(random), times(1e-6, random_hull(random))};
  }
  throw std::logic_error("a family without polyhedra");
}

PosePair3 draw_poses(Family3 family, const PolyhedronPair& pair, Random3& random) {
  if (is_placed_by_vertices(family)) return {where_it_was_made(pair.a), where_it_was_made(pair.b)};

  const double far = family == Family3::far_from_origin ? 1e8 : 10;
  const bool parallel = family == Family3::nearly_parallel_faces;
  const Point3 place{uniform_between(random, -far, far), uniform_between(random, -far, far),
                     uniform_between(random, -far, far)};
  PosePair3 poses;
  poses.a = turned_at_random(place, random);
  poses.b =
      parallel ? turned_a_little(poses.a, random_direction(random), 1e-10) : turned_at_random(place, random);
  const MinkowskiFacets facets({&pair.a, poses.a}, {&pair.b, poses.b});

  // Nearly parallel faces face each other, shifted sideways.
  const Point3 start =
      parallel ? Point3{uniform_between(random, -0.2, 0.2), uniform_between(random, -0.2, 0.2), 0} : Point3{};
  const Point3 direction = parallel ? Point3{0, 0, 1} : random_direction(random);
  const double size = std::min(radius(pair.a), radius(pair.b));
  // What is thinner than the wanted depth is laid as deep as it goes, nearly.
  const double gap = std::max(draw_gap(size, random), 0.9 * facets.separation(start).gap);
  const double distance = facets.distance_for(start, direction, gap);
  const Point3 to_b = turned(poses.a, start + distance * direction);
  poses.b.position[0] = place.x + to_b.x;
  poses.b.position[1] = place.y + to_b.y;
  poses.b.position[2] = place.z + to_b.z;
  return poses;
}

}  // namespace halfspace_test
