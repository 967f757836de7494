#pragma once

#include <cstddef>
#include <vector>

#include "common/vector.h"

namespace halfspace::cli {

/// The smallest box along the axes around points.
struct Box {
  void add(const Point& point);
  Point sides() const { return minus(high, low); }
  /// The distance of a point from the box; 0 within.
  double distance(const Point& point) const;

  Point low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Point high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
};

/// Divides points into so many parts of equal size, to one point, by recursive bisection across the longest
/// side of their box. @return the indices of each part, in ascending order
std::vector<std::vector<std::size_t>> bisect(const std::vector<Point>& points, std::size_t parts);

}  // namespace halfspace::cli
