#pragma once

#include "narrow_phase/space/minkowski_difference.h"

namespace halfspace {

/// Up to four corners of a Minkowski difference, and the point of their hull nearest to the origin.
struct Simplex {
  Corner corner[4];
  int count = 0;
  Vector<3> nearest = Vector<3>::Zero();

  bool has(const Corner& c) const {
    for (int i = 0; i < count; ++i) {
      if (corner[i].same_as(c)) return true;
    }
    return false;
  }
  /// Adds a corner, and removes those not needed for the point nearest to the origin. Four remain when the
  /// origin is inside.
  void add(const Corner& c);
};

}  // namespace halfspace
