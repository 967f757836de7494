#include "geometry/polyhedron/check.h"

#include <algorithm>
#include <cmath>

#include "geometry/box.h"
#include "geometry/polyhedron/facets.h"
#include "geometry/polyhedron/support_tree.h"
#include "geometry/polyhedron/surface.h"
#include "geometry/polyhedron/topology.h"
#include "geometry/tolerances.h"
#include "geometry/unit_vector.h"

namespace halfspace {
namespace {

// Second moments grow with the fifth power of the size: within these limits neither they nor their products
// with a density overflow or underflow.
constexpr double largest_allowed = 1e50;
constexpr double smallest_polyhedron_extent = 1e-50;

/// The lowest and highest height over a plane, and the highest vertex.
struct Heights {
  double lowest = HUGE_VAL;
  double highest = -HUGE_VAL;
  std::int64_t vertex = -1;

  void add(double height, std::int64_t v) {
    lowest = std::min(lowest, height);
    if (height <= highest) return;
    highest = height;
    vertex = v;
  }
};

Heights heights_of_loop(const Polyhedron& p, std::int32_t face, const Vector<3>& origin,
                        const Vector<3>& normal) {
  Heights heights;
  for (const std::int32_t v : p.loop(face)) heights.add(normal.dot(p.vertices[std::size_t(v)] - origin), v);
  return heights;
}

PolyhedronFault first_out_of_range(std::span<const Vector<3>> points) {
  Box<3> box;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite() || points[i].cwiseAbs().maxCoeff() > largest_allowed)
      return {Fault::out_of_range, std::int64_t(i), -1};
    box.include(points[i]);
  }
  if (box.extent() < smallest_polyhedron_extent) return {Fault::out_of_range, -1, -1};
  return {};
}

PolyhedronFault first_coinciding(const Polyhedron& p) {
  Array<std::int32_t> order(p.vertices.size(), p.memory());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = std::int32_t(i);
  const auto at = [&](std::int32_t i) -> const Vector<3>& { return p.vertices[std::size_t(i)]; };
  std::sort(order.begin(), order.end(), [&](std::int32_t i, std::int32_t j) {
    for (int axis = 0; axis < 3; ++axis) {
      if (at(i)[axis] != at(j)[axis]) return at(i)[axis] < at(j)[axis];
    }
    return i < j;
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (at(order[i - 1]) == at(order[i])) return {Fault::coinciding_vertices, order[i], -1};
  }
  return {};
}

bool all_in_one_plane(std::span<const Vector<3>> points) {
  // From three points far apart, so that the plane is accurate.
  const auto farthest = [&](auto distance) {
    return *std::max_element(points.begin(), points.end(), [&](const Vector<3>& p, const Vector<3>& q) {
      return distance(p) < distance(q);
    });
  };
  const double tolerance = flatness_tolerance(largest_coordinate(points));
  const Vector<3> a = farthest([&](const Vector<3>& p) { return (p - points[0]).squaredNorm(); });
  const Vector<3> b = farthest([&](const Vector<3>& p) { return (p - a).squaredNorm(); });
  const Vector<3> axis = (b - a).normalized();
  const Vector<3> c = farthest([&](const Vector<3>& p) { return cross_product(axis, p - a).squaredNorm(); });
  const Vector<3> across = cross_product(axis, c - a);
  if (across.norm() <= tolerance) return true;
  const Vector<3> normal = across.normalized();
  return std::all_of(points.begin(), points.end(),
                     [&](const Vector<3>& p) { return std::abs(normal.dot(p - a)) <= tolerance; });
}

PolyhedronFault check_vertices_and_surface(const Polyhedron& p) {
  if (const PolyhedronFault r = check_points(p.vertices); r.fault != Fault::none) return r;
  if (const PolyhedronFault r = check_surface(p); r.fault != Fault::none) return r;
  return first_coinciding(p);
}

/// Convex by definition: all vertices are behind all planes, by a search that does not rely on convexity.
PolyhedronFault first_misplaced(const Polyhedron& p) {
  const double tolerance = flatness_tolerance(largest_coordinate(p.vertices));
  const SupportTree vertices(p.vertices, p.memory());
  for (std::int32_t f = 0; f < p.face_count(); ++f) {
    const Vector<3>& normal = p.normals[std::size_t(f)];
    const Vector<3>& origin = p.corner(f, 0);
    const Heights own = heights_of_loop(p, f, origin, normal);
    if (own.highest - own.lowest > 2 * tolerance) return {Fault::face_not_plane, own.vertex, f};

    const double plane = 0.5 * (own.lowest + own.highest);
    const auto height = [&](const Vector<3>& v) { return normal.dot(v - origin) - plane; };
    const HighestPoint highest = vertices.highest(normal, tolerance, height);
    if (highest.height > tolerance) return {Fault::vertex_outside_face, highest.point, f};
    const auto is_behind = [&](const Vector<3>& v) { return height(v) < -tolerance; };
    if (std::none_of(p.vertices.begin(), p.vertices.end(), is_behind)) return {Fault::zero_volume, -1, f};
  }
  return {};
}

/// Calls is_faulty(face, neighbour) for each edge until it returns true.
template <class IsFaulty>
PolyhedronFault first_coplanar(const Polyhedron& p, IsFaulty is_faulty) {
  const HalfEdges half_edges(p);
  for (std::int32_t h = 0; h < half_edges.count(); ++h) {
    const std::int32_t face = half_edges.face(h);
    const std::int32_t neighbour = half_edges.face(half_edges.twin(h));
    if (is_faulty(face, neighbour)) return {Fault::coplanar_faces, -1, face};
  }
  return {};
}

PolyhedronFault first_parallel_neighbours(const Polyhedron& p) {
  return first_coplanar(p, [&](std::int32_t face, std::int32_t neighbour) {
    // Each component of a unit normal has an error of about one ulp.
    const Vector<3>& a = p.normals[std::size_t(face)];
    const Vector<3>& b = p.normals[std::size_t(neighbour)];
    return a.dot(b) > 0 && cross_product(a, b).norm() <= 4 * machine_epsilon;
  });
}

PolyhedronFault first_split_face(const Polyhedron& p) {
  const double tolerance = coplanarity_tolerance(largest_coordinate(p.vertices));
  const auto is_in_plane_of = [&](std::int32_t other, std::int32_t face) {
    const Vector<3>&origin = p.corner(face, 0), &normal = p.normals[std::size_t(face)];
    return std::ranges::all_of(p.loop(other), [&](std::int32_t v) {
      return normal.dot(p.vertices[std::size_t(v)] - origin) >= -tolerance;
    });
  };
  return first_coplanar(p, [&](std::int32_t face, std::int32_t neighbour) {
    return is_in_plane_of(neighbour, face) && is_in_plane_of(face, neighbour);
  });
}

PolyhedronFault fit_normals(Polyhedron& p) {
  p.normals.clear();
  for (std::int32_t f = 0; f < p.face_count(); ++f) {
    const Vector<3> area = area_vector(p, f);
    double longest = 0;
    for (std::size_t i = 1; i < p.loop(f).size(); ++i)
      longest = std::max(longest, (p.corner(f, i) - p.corner(f, 0)).squaredNorm());
    // A face narrower than a few ulps of its length has no normal.
    if (area.norm() <= 8 * machine_epsilon * longest) return {Fault::face_without_area, -1, f};
    p.normals.push_back((area / power_of_two_in(area)).normalized());
  }
  return {};
}

/// The last part of complete_polyhedron(), for loops that are counter-clockwise.
PolyhedronFault complete_faces(Polyhedron& p) {
  if (const PolyhedronFault r = fit_normals(p); r.fault != Fault::none) return r;
  if (const PolyhedronFault r = first_misplaced(p); r.fault != Fault::none) return r;
  return first_split_face(p);
}

}  // namespace

double flatness_tolerance(double reach) { return 256 * machine_epsilon * reach; }

double coplanarity_tolerance(double reach) { return place_rounding * reach; }

PolyhedronFault check_points(std::span<const Vector<3>> points) {
  if (points.size() < 4) return {Fault::fewer_than_four, -1, -1};
  if (const PolyhedronFault r = first_out_of_range(points); r.fault != Fault::none) return r;
  if (all_in_one_plane(points)) return {Fault::zero_volume, -1, -1};
  return {};
}

PolyhedronFault check_polyhedron(const Polyhedron& polyhedron) {
  if (const PolyhedronFault r = check_vertices_and_surface(polyhedron); r.fault != Fault::none) return r;
  if (const PolyhedronFault r = first_misplaced(polyhedron); r.fault != Fault::none) return r;
  return first_parallel_neighbours(polyhedron);
}

PolyhedronFault complete_polyhedron(Polyhedron& polyhedron) {
  if (const PolyhedronFault r = check_vertices_and_surface(polyhedron); r.fault != Fault::none) return r;
  turn_outward(polyhedron);
  return complete_faces(polyhedron);
}

PolyhedronFault complete_moved_polyhedron(Polyhedron& polyhedron) {
  if (const PolyhedronFault r = check_points(polyhedron.vertices); r.fault != Fault::none) return r;
  if (const PolyhedronFault r = first_coinciding(polyhedron); r.fault != Fault::none) return r;
  return complete_faces(polyhedron);
}

}  // namespace halfspace
