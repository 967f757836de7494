#pragma once

#include <algorithm>
#include <span>

#include "geometry/vector.h"

namespace halfspace {

inline Vector<2> between(const Vector<2>& from, const Vector<2>& to, double share) {
  return from + share * (to - from);
}

/// Where an edge leaves a half-plane. Worked out from its inner end to its outer one, so that both polygons
/// at the edge find the same bits. Corners are whatever between() knows.
template <class Corner>
Corner crossing(const Corner& inside, double height_inside, const Corner& outside, double height_outside) {
  return between(inside, outside, height_inside / (height_inside - height_outside));
}

/// One step of Sutherland and Hodgman (1974): calls `add` for the corners of what of a convex polygon has a
/// height of at most 0. Corners within `rounding` of that count as on it: where edges coincide but for
/// rounding there is no corner.
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
