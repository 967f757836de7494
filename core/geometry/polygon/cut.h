#pragma once

#include <span>

#include "geometry/vector.h"

namespace halfspace {

/// The two parts of a convex polygon, each counter-clockwise or empty.
struct PolygonParts {
  Array<Vector<2>> behind;
  Array<Vector<2>> ahead;
  bool is_rather_ahead;  // it reaches farther to there

  bool is_cut() const { return !behind.empty() && !ahead.empty(); }
};

/// Cuts a counter-clockwise convex polygon by the line through `point` with normal `normal`. Both parts get
/// the same new vertices, so that neighbours stay exactly adjacent. A part that the line touches only to
/// rounding is empty; of a polygon that is itself no wider than rounding both may be.
PolygonParts cut_polygon(std::span<const Vector<2>> vertices, const Vector<2>& point, const Vector<2>& normal,
                         Memory* memory);

}  // namespace halfspace
