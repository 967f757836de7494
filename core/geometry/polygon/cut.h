#pragma once

#include <span>

#include "geometry/vector.h"

namespace halfspace {

/// The two parts of a convex polygon, each counter-clockwise or empty.
struct PolygonParts {
  Array<Vector<2>> behind;
  Array<Vector<2>> ahead;
  bool is_rather_ahead;  // the larger height is ahead

  bool is_cut() const { return !behind.empty() && !ahead.empty(); }
};

/// Cuts a counter-clockwise convex polygon by the line through `point` with normal `normal`. Both parts get
/// the same new vertices, so that neighbours remain exactly adjacent. A part that the line touches only to
/// rounding is empty; both may be if the polygon is no wider than rounding.
PolygonParts cut_polygon(std::span<const Vector<2>> vertices, const Vector<2>& point, const Vector<2>& normal,
                         Memory* memory);

}  // namespace halfspace
