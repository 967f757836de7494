#include "force/overlap.h"

#include <algorithm>

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

  /// One straight piece, cut off where it leaves the half-space or the edge, [-half_length, half_length]. Where an outline overhangs it runs
  /// back under what was added, and is taken off again.
  void add(DepthPoint p, DepthPoint q, double half_length, bool overhangs) {
    if (p.s > q.s) std::swap(p, q);
    const double sign = overhangs ? -1 : 1;
    const double slope = q.s > p.s ? (q.depth - p.depth) / (q.s - p.s) : 0;
    const auto cut_at = [&](DepthPoint& end, double s) { end = {s, p.depth + slope * (s - p.s)}; };
    const DepthPoint p0 = p;
    const auto zero = [&] { return p0.s - p0.depth / slope; };
    if (q.depth < 0 && slope < 0) q = {zero(), 0};
    if (p.depth < 0 && slope > 0) p = {zero(), 0};
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

Overlap measure_overlap(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, const PotentialPair& pair) {
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

  Profile profile;
  const DepthPoint deepest = depth_at(pair.vertex);
  const auto walk = [&](auto neighbour, double outward) {
    DepthPoint here = deepest;
    for (int v = neighbour(pair.vertex); here.depth > 0 && v != pair.vertex; v = neighbour(v)) {
      const DepthPoint there = depth_at(v);
      if (there.depth > here.depth) break;  // round the far side: its outline faces the other way
      profile.add(here, there, half_length, outward * (there.s - here.s) < 0);
      here = there;
    }
  };
  // The outlines run against each other: the other's counter-clockwise leads towards the start of the edge.
  walk([&](int v) { return other.next(v); }, -1);
  walk([&](int v) { return other.previous(v); }, 1);

  Overlap overlap;
  if (profile.area > 0) {
    overlap.area = profile.area;
    overlap.depth_squared = profile.depth_squared;
    overlap.width = profile.last - profile.first;
    overlap.center = middle + profile.moment / profile.area * tangent;
    if (!a_owns) overlap.center += to_b;
  }
  return overlap;
}

}  // namespace halfspace
