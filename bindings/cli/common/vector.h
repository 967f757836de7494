#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace halfspace::cli {

/// A point or vector; in 2D its last component is 0.
using Point = std::array<double, 3>;

inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Point plus(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

inline Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

inline Point times(double factor, const Point& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }

inline double length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }

inline Point unit(const Point& a) { return times(1 / length(a), a); }

inline Point point_of(const double components[3]) { return {components[0], components[1], components[2]}; }

inline double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = minus(b, a);
  const double part = std::clamp(dot(minus(p, a), along) / dot(along, along), 0.0, 1.0);
  return length(minus(p, plus(a, times(part, along))));
}

/// Newell's normal of a plane loop, with twice its area as length; outwards if the loop runs
/// counter-clockwise seen from outside.
inline Point area_normal(const std::vector<Point>& loop) {
  Point normal{};
  for (std::size_t i = 0; i < loop.size(); ++i)
    normal = plus(normal, cross(minus(loop[i], loop[0]), minus(loop[(i + 1) % loop.size()], loop[0])));
  return normal;
}

}  // namespace halfspace::cli
