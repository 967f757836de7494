#include "overlap.h"

#include <algorithm>
#include <cmath>

namespace halfspace_trade {
namespace {

/// Corners in their places, and the directions in which faces look and edges run.
struct Placed {
  std::vector<Vector> corners;
  std::vector<Vector> normals;
  std::vector<Vector> edges;
  double radius = 0;
};

double dot(const Vector& p, const Vector& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
Vector cross(const Vector& p, const Vector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

Vector turned(const Quaternion& q, const Vector& v) {
  const Vector axis = {q[0], q[1], q[2]};
  const Vector once = cross(axis, v), twice = cross(axis, once);
  Vector sum;
  for (std::size_t k = 0; k < 3; ++k) sum[k] = v[k] + 2 * (q[3] * once[k] + twice[k]);
  return sum;
}

Vector difference(const Vector& p, const Vector& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

/// Normals of the faces of a hull, and its edges, by trying planes through any three corners. Diagonals of
/// faces count as edges, too: no depth becomes less by more axes than are needed.
void add_hull(Placed& to) {
  const std::vector<Vector>& corners = to.corners;
  const std::size_t count = corners.size();
  constexpr double rounding = 1e-9;  // m
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      int faces_at_edge = 0;
      for (std::size_t k = 0; k < count; ++k) {
        Vector normal = cross(difference(corners[j], corners[i]), difference(corners[k], corners[i]));
        const double length = std::sqrt(dot(normal, normal));
        if (length < rounding) continue;
        for (double& part : normal) part /= length;
        double low = 0, high = 0;
        for (const Vector& corner : corners) {
          const double height = dot(normal, difference(corner, corners[i]));
          low = std::min(low, height);
          high = std::max(high, height);
        }
        if (low < -rounding && high > rounding) continue;
        ++faces_at_edge;
        if (k > j) to.normals.push_back(normal);
      }
      if (faces_at_edge >= 2) to.edges.push_back(difference(corners[j], corners[i]));
    }
  }
}

Placed placed(const Body& body, int dimension) {
  Placed at;
  const std::vector<Vector> own = corners_of(body, dimension);
  for (const Vector& corner : own) {
    const Vector arm = turned(body.rotation, corner);
    at.radius = std::max(at.radius, std::sqrt(dot(arm, arm)));
    at.corners.push_back({body.position[0] + arm[0], body.position[1] + arm[1], body.position[2] + arm[2]});
  }
  if (dimension == 3 && !body.corners.empty()) {
    add_hull(at);
    return at;
  }
  if (dimension == 3) {
    for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
      at.normals.push_back(turned(body.rotation, axis));
      at.edges.push_back(at.normals.back());
    }
    return at;
  }
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Vector &from = at.corners[i], &to = at.corners[(i + 1) % own.size()];
    at.normals.push_back({to[1] - from[1], from[0] - to[0], 0});
  }
  return at;
}

/// How far the two overlap along an axis, or HUGE_VAL when it has no direction.
double overlap_along(Vector axis, const Placed& a, const Placed& b) {
  const double length = std::sqrt(dot(axis, axis));
  if (length < 1e-6) return HUGE_VAL;
  const auto extent = [&](const Placed& body) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Vector& corner : body.corners) {
      low = std::min(low, dot(axis, corner) / length);
      high = std::max(high, dot(axis, corner) / length);
    }
    return std::pair(low, high);
  };
  const auto [a_low, a_high] = extent(a);
  const auto [b_low, b_high] = extent(b);
  return std::min(a_high - b_low, b_high - a_low);
}

double overlap(const Placed& a, const Placed& b) {
  double least = HUGE_VAL;
  for (const Placed* body : {&a, &b})
    for (const Vector& normal : body->normals) least = std::min(least, overlap_along(normal, a, b));
  for (const Vector& of_a : a.edges) {
    if (least <= 0) break;
    for (const Vector& of_b : b.edges) least = std::min(least, overlap_along(cross(of_a, of_b), a, b));
  }
  return least;
}

}  // namespace

double mean_overlap(const std::vector<Body>& bodies, int dimension) {
  std::vector<Placed> all;
  for (const Body& body : bodies) all.push_back(placed(body, dimension));
  double sum = 0;
  long count = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (bodies[i].is_fixed && bodies[k].is_fixed) continue;
      Vector between = bodies[i].position;
      for (std::size_t c = 0; c < 3; ++c) between[c] -= bodies[k].position[c];
      const double reach = all[i].radius + all[k].radius;
      if (dot(between, between) > reach * reach) continue;
      const double depth = overlap(all[i], all[k]);
      if (depth <= 0) continue;
      sum += depth;
      ++count;
    }
  }
  return count > 0 ? sum / double(count) : 0;
}

}  // namespace halfspace_trade
