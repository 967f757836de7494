#pragma once

#include <algorithm>
#include <cmath>

#include "common/vector.h"

namespace halfspace::cli {

/// The smallest box along the axes around points.
struct Box {
  void add(const Point& point) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  }
  Point sides() const { return minus(high, low); }
  /// The distance of a point from the box; 0 within.
  double distance(const Point& point) const {
    Point outside{};
    for (std::size_t k = 0; k < 3; ++k) outside[k] = std::max({low[k] - point[k], 0.0, point[k] - high[k]});
    return length(outside);
  }

  Point low{INFINITY, INFINITY, INFINITY};
  Point high{-INFINITY, -INFINITY, -INFINITY};
};

inline Box box_of(const std::vector<Point>& points) {
  Box box;
  for (const Point& point : points) box.add(point);
  return box;
}

}  // namespace halfspace::cli
