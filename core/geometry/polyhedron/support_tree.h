#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "geometry/box.h"

namespace halfspace {

/// A point, and its height in some direction.
struct HighestPoint {
  double height = -HUGE_VAL;
  std::int64_t point = -1;
};

/// Finds the highest of many points in any direction, without relying on convexity: boxes of points that are
/// divided in two while they have many, and are left out where none of their corners is high enough. A few
/// points are one box, without a copy.
class SupportTree {
 public:
  /// The points must remain.
  SupportTree(std::span<const Vector<3>> points, Memory* memory);

  /// The highest point, the first one of equals, by a function that is the height along `normal` over some
  /// plane, rounded. Points that are not above the floor may be missed.
  template <class Height>
  HighestPoint highest(const Vector<3>& normal, double floor, Height height) const {
    HighestPoint found;
    search(0, 0, points_.size(), normal, floor, height, found);
    return found;
  }

 private:
  static constexpr std::size_t points_per_box = 64;

  /// The box of the points from `begin` to `end` is `boxes_[place]`; its halves are at 2 place + 1 and + 2.
  void divide(std::size_t place, std::size_t begin, std::size_t end);

  template <class Height>
  void search(std::size_t place, std::size_t begin, std::size_t end, const Vector<3>& normal, double floor,
              Height height, HighestPoint& found) const {
    if (end - begin <= points_per_box) {
      for (std::size_t i = begin; i < end; ++i) {
        const std::int64_t point = order_.empty() ? std::int64_t(i) : order_[i];
        const double at = height(points_[std::size_t(point)]);
        if (at > found.height || (at == found.height && point < found.point)) found = {at, point};
      }
      return;
    }
    const std::size_t middle = (begin + end) / 2, lower = 2 * place + 1, upper = 2 * place + 2;
    const double of_lower = height(corner(boxes_[lower], normal));
    const double of_upper = height(corner(boxes_[upper], normal));
    const auto is_high = [&](double bound) { return bound > std::max(found.height, floor) - rounding_; };
    if (of_upper > of_lower && is_high(of_upper)) search(upper, middle, end, normal, floor, height, found);
    if (is_high(of_lower)) search(lower, begin, middle, normal, floor, height, found);
    if (of_upper <= of_lower && is_high(of_upper)) search(upper, middle, end, normal, floor, height, found);
  }

  static Vector<3> corner(const Box<3>& box, const Vector<3>& normal) {
    return (normal.array() > 0).select(box.upper, box.lower);
  }

  std::span<const Vector<3>> points_;
  double rounding_ = 0;        ///< of heights
  Array<std::int64_t> order_;  ///< points by box; empty if there is one box
  Array<Box<3>> boxes_;
};

}  // namespace halfspace
