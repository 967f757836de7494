#pragma once

#include <cmath>

#include "geometry/vector.h"

namespace halfspace {

/// The direction in which the path a -> b -> c turns.
enum class Turn { right = -1, straight = 0, left = 1 };

/// Sign of twice the area of (a, b, c); "straight" when it is below the error bound of its own evaluation
/// (the static part of Shewchuk's orient2d filter, 1997).
inline Turn turn(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c) {
  constexpr double unit_roundoff = 0x1p-53;
  constexpr double bound = (3 + 16 * unit_roundoff) * unit_roundoff;
  const double left = (b.x() - a.x()) * (c.y() - b.y());
  const double right = (b.y() - a.y()) * (c.x() - b.x());
  const double area = left - right;
  const double error = bound * (std::abs(left) + std::abs(right));
  if (area > error) return Turn::left;
  if (area < -error) return Turn::right;
  return Turn::straight;
}

}  // namespace halfspace
