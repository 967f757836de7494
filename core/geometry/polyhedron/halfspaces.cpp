#include "geometry/polyhedron/halfspaces.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polyhedron/cut.h"
#include "geometry/polyhedron/hull.h"
#include "geometry/polyhedron/simplify.h"
#include "geometry/polyhedron/topology.h"
#include "geometry/unit_vector.h"

namespace halfspace {
namespace {

PolyhedronFault to_unit_normals(Array<Halfspace<3>>& halfspaces) {
  for (std::size_t i = 0; i < halfspaces.size(); ++i) {
    Halfspace<3>& h = halfspaces[i];
    if (!h.normal.allFinite() || !std::isfinite(h.offset)) return {Fault::out_of_range, -1, std::int64_t(i)};
    if (h.normal.isZero(0)) return {Fault::no_direction, -1, std::int64_t(i)};
    const double power = power_of_two_in(h.normal);
    const Vector<3> normal = h.normal / power;
    const double length = normal.stableNorm();
    h = {normal / length, h.offset / power / length};
  }
  return {};
}

/// The half-space of each dual vertex: the hull keeps the order of the points, and equal points are equal
/// half-spaces.
Array<std::int32_t> half_spaces_of(const Polyhedron& dual, std::span<const Vector<3>> points) {
  Array<std::int32_t> found(dual.memory());
  std::size_t i = 0;
  for (const Vector<3>& vertex : dual.vertices) {
    while (points[i] != vertex) ++i;
    found.push_back(std::int32_t(i++));
  }
  return found;
}

/// The least squares intersection of planes, by iterative refinement from a nearby point.
class Meeting {
 public:
  Meeting(std::span<const Halfspace<3>> halfspaces, std::span<const std::int32_t> planes)
      : halfspaces_(halfspaces), planes_(planes) {}

  Vector<3> from(Vector<3> point) const {
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
    for (const std::int32_t i : planes_) normals += at(i).normal * at(i).normal.transpose();
    const Eigen::LDLT<Eigen::Matrix3d> solver(normals);
    for (double miss = farthest(point);;) {
      Vector<3> pull = Vector<3>::Zero();
      for (const std::int32_t i : planes_) pull += gap(i, point) * at(i).normal;
      const Vector<3> nearer = point + solver.solve(pull);
      const double next_miss = farthest(nearer);
      if (!(next_miss < miss)) return point;
      point = nearer;
      miss = next_miss;
    }
  }

 private:
  const Halfspace<3>& at(std::int32_t i) const { return halfspaces_[std::size_t(i)]; }
  double gap(std::int32_t i, const Vector<3>& point) const { return at(i).offset - at(i).normal.dot(point); }
  double farthest(const Vector<3>& point) const {
    double farthest = 0;
    for (const std::int32_t i : planes_) farthest = std::max(farthest, std::abs(gap(i, point)));
    return farthest;
  }

  std::span<const Halfspace<3>> halfspaces_;
  std::span<const std::int32_t> planes_;
};

/// Makes a vertex where the planes of each dual face meet, and a face around each dual vertex. False, as the
/// intersection is unbounded, when the origin is not behind a dual face.
bool take_dual(const Polyhedron& dual, std::span<const std::int32_t> source,
               std::span<const Halfspace<3>> halfspaces, Polyhedron& polyhedron) {
  const double rounding = coplanarity_tolerance(largest_coordinate(dual.vertices));
  Array<std::int32_t> planes(dual.memory());
  for (std::int32_t f = 0; f < dual.face_count(); ++f) {
    const Vector<3>& normal = dual.normals[std::size_t(f)];
    const double offset = normal.dot(dual.corner(f, 0));
    if (offset <= rounding) return false;
    planes.clear();
    for (const std::int32_t v : dual.loop(f)) planes.push_back(source[std::size_t(v)]);
    polyhedron.vertices.push_back(Meeting(halfspaces, planes).from(normal / offset));
  }

  const TopologyArrays arrays(dual, dual.memory());
  const Topology& topology = arrays.view();
  for (std::int32_t v = 0; v < topology.vertex_count; ++v) {
    for (std::int32_t k = topology.first_of_vertex[v]; k < topology.first_of_vertex[v + 1]; ++k) {
      polyhedron.append_corner(topology.vertex_face[k]);
    }
    polyhedron.end_face();
    polyhedron.normals.push_back(halfspaces[std::size_t(source[std::size_t(v)])].normal);
  }
  return true;
}

/// Cuts by the half-spaces that the dual hull merged: in a thin region they are too similar there.
PolyhedronFault cut_by_all(std::span<const Halfspace<3>> halfspaces, Polyhedron& polyhedron) {
  for (std::size_t i = 0; i < halfspaces.size(); ++i) {
    const Halfspace<3>& h = halfspaces[i];
    double highest = -HUGE_VAL;
    for (const Vector<3>& v : polyhedron.vertices) highest = std::max(highest, h.normal.dot(v) - h.offset);
    if (highest <= flatness_tolerance(largest_coordinate(polyhedron.vertices))) continue;
    PolyhedronParts parts = cut_polyhedron(polyhedron, h.offset * h.normal, h.normal, polyhedron.memory());
    if (parts.behind.is_empty()) return {Fault::no_common_point, -1, -1};
    polyhedron = std::move(parts.behind);
  }
  return {};
}

PolyhedronFault intersect(std::span<const Halfspace<3>> given, Polyhedron& polyhedron) {
  if (given.size() < 4) return {Fault::unbounded, -1, -1};
  Array<Halfspace<3>> halfspaces(given.begin(), given.end(), polyhedron.memory());
  if (const PolyhedronFault r = to_unit_normals(halfspaces); r.fault != Fault::none) return r;

  const Interior inside = farthest_inside(halfspaces, polyhedron.memory());
  const double reach = inside.point.cwiseAbs().maxCoeff() + std::abs(inside.clearance);
  if (!(inside.clearance > flatness_tolerance(reach))) return {Fault::no_common_point, -1, -1};

  // Relative to the inner point, so that all further offsets are exact and as small as the region.
  Array<Vector<3>> points(polyhedron.memory());
  for (Halfspace<3>& h : halfspaces) {
    h.offset -= h.normal.dot(inside.point);
    points.push_back(h.normal / h.offset);
  }
  Polyhedron dual(polyhedron.memory());
  const PolyhedronFault of_dual = convex_hull(points, dual);
  if (of_dual.fault == Fault::zero_volume) return {Fault::unbounded, -1, -1};
  if (of_dual.fault != Fault::none) return of_dual;
  if (!take_dual(dual, half_spaces_of(dual, points), halfspaces, polyhedron))
    return {Fault::unbounded, -1, -1};
  if (const PolyhedronFault r = cut_by_all(halfspaces, polyhedron); r.fault != Fault::none) return r;
  for (Vector<3>& v : polyhedron.vertices) v += inside.point;
  // Planes that meet in one vertex to rounding make several, which are merged.
  weld_short_edges(polyhedron, coplanarity_tolerance(largest_coordinate(polyhedron.vertices)));
  return check_polyhedron(polyhedron);
}

}  // namespace

PolyhedronFault polyhedron_from_halfspaces(std::span<const Halfspace<3>> halfspaces, Polyhedron& polyhedron,
                                           std::int64_t& redundant) {
  polyhedron = Polyhedron(polyhedron.memory());
  const PolyhedronFault report = intersect(halfspaces, polyhedron);
  if (report.fault != Fault::none) polyhedron = Polyhedron(polyhedron.memory());
  redundant = std::int64_t(halfspaces.size()) - polyhedron.face_count();
  return report;
}

}  // namespace halfspace
