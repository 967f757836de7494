#include <algorithm>

#include "force/overlap.h"

namespace halfspace {
namespace {

/// Depth as it goes along the contact plane.
struct DepthPoint {
  double s;
  double depth;
};

/// Trapezoids under a piecewise linear depth.
struct Profile {
  double area = 0;
  double moment = 0;
  double depth_squared = 0;
  double first = HUGE_VAL;
  double last = -HUGE_VAL;

  /// One straight piece, cut off where it leaves the half-space or the edge, [-half_length, half_length].
  /// Where an outline overhangs it runs back under what was added, and is taken off again.
  void add(DepthPoint p, DepthPoint q, double half_length, bool overhangs) {
    if (p.s > q.s) std::swap(p, q);
    const double sign = overhangs ? -1 : 1;
    const double slope = q.s > p.s ? (q.depth - p.depth) / (q.s - p.s) : 0;
    const auto cut_at = [&](DepthPoint& end, double s) { end = {s, end.depth + slope * (s - end.s)}; };
    const auto cut_at_plane = [&](DepthPoint& end, const DepthPoint& inside) {
      end = {inside.s - inside.depth / slope, 0};
    };
    if (q.depth < 0 && slope < 0) cut_at_plane(q, p);
    if (p.depth < 0 && slope > 0) cut_at_plane(p, q);
    if (p.s < -half_length) cut_at(p, -half_length);
    if (q.s > half_length) cut_at(q, half_length);
    if (!(q.s > p.s) || p.depth < 0 || q.depth < 0) return;
    const double width = sign * (q.s - p.s);
    const double piece = 0.5 * width * (p.depth + q.depth);
    area += piece;
    moment += width * (p.s * (2 * p.depth + q.depth) + q.s * (p.depth + 2 * q.depth)) / 6;
    depth_squared += width * (p.depth * p.depth + p.depth * q.depth + q.depth * q.depth) / 3;
    first = std::min(first, p.s);
    last = std::max(last, q.s);
  }
};

}  // namespace

Overlap<2> measure_overlap(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                           const PotentialPair<2>& pair) {
  const bool a_owns = pair.owner == 0;
  const Outline<2>& owner = a_owns ? a : b;
  const Outline<2>& other = a_owns ? b : a;
  const Vector<2> to_other = a_owns ? to_b : Vector<2>(-to_b);
  const Vector<2> normal = owner.normal(pair.edge);
  const Vector<2> tangent = perpendicular(normal);
  const Vector<2> start = owner.vertex(pair.edge);
  const Vector<2> end = owner.vertex(owner.next(pair.edge));
  const Vector<2> middle = 0.5 * (start + end);
  const double half_length = 0.5 * tangent.dot(end - start);
  const auto depth_at = [&](int vertex) {
    const Vector<2> p = other.vertex(vertex) + to_other;
    return DepthPoint{tangent.dot(p - middle), owner.offset[pair.edge] - normal.dot(p)};
  };

  const DepthPoint deepest = depth_at(pair.vertex);
  const auto walk = [&](auto neighbour, double outward) {
    Profile profile;
    DepthPoint here = deepest;
    for (int v = neighbour(pair.vertex); here.depth > 0 && v != pair.vertex; v = neighbour(v)) {
      const DepthPoint there = depth_at(v);
      if (there.depth > here.depth) break;  // round the far side: its outline faces the other way
      profile.add(here, there, half_length, outward * (there.s - here.s) < 0);
      here = there;
    }
    return profile;
  };
  // The outlines run against each other: the other's counter-clockwise leads towards the start of the edge.
  // Each way is summed by itself, so that a mirrored pair finds the same bits.
  const Profile towards_start = walk([&](int v) { return other.next(v); }, -1);
  const Profile towards_end = walk([&](int v) { return other.previous(v); }, 1);
  const double area = towards_start.area + towards_end.area;

  Overlap<2> overlap;
  if (area > 0) {
    overlap.content = area;
    overlap.depth_squared = towards_start.depth_squared + towards_end.depth_squared;
    overlap.base =
        std::max(towards_start.last, towards_end.last) - std::min(towards_start.first, towards_end.first);
    overlap.center = middle + (towards_start.moment + towards_end.moment) / area * tangent;
    if (!a_owns) overlap.center += to_b;
  }
  return overlap;
}

}  // namespace halfspace
