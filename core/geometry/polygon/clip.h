#pragma once

#include <algorithm>
#include <span>

#include "geometry/vector.h"

namespace halfspace {

inline Vector<2> between(const Vector<2>& from, const Vector<2>& to, double share) {
  return from + share * (to - from);
}
inline Vector<3> between(const Vector<3>& from, const Vector<3>& to, double share) {
  return from + share * (to - from);
}

/// The point where an edge leaves a half-plane. Computed from its inner to its outer end, so that both
/// polygons at the edge get the same bits. Corner is any type with between().
template <class Corner>
Corner crossing(const Corner& inside, double height_inside, const Corner& outside, double height_outside) {
  return between(inside, outside, height_inside / (height_inside - height_outside));
}

/// One step of Sutherland and Hodgman (1974): calls `add` for each corner of the part of a convex polygon
/// with height <= 0. Corners within `rounding` of 0 count as 0, so that edges that coincide to rounding add
/// no corner.
template <class Corner, class Height, class Add>
void clip(std::span<const Corner> polygon, Height height, double rounding, Add add) {
  if (polygon.empty()) return;
  const Corner* before = &polygon.back();
  double height_before = height(*before);
  for (const Corner& corner : polygon) {
    const double here = height(corner);
    if (std::min(here, height_before) < -rounding && std::max(here, height_before) > rounding) {
      add(here < height_before ? crossing(corner, here, *before, height_before)
                               : crossing(*before, height_before, corner, here));
    }
    if (here <= rounding) add(corner);
    before = &corner;
    height_before = here;
  }
}

}  // namespace halfspace
