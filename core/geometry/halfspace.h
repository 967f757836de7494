#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// The points whose depth is not negative, in the plane a half-plane. The normal points out of it.
template <int D>
struct Halfspace {
  Vector<D> normal;  // of any length but 0: depths are as many times too large
  double offset;

  double depth(const Vector<D>& p) const { return offset - normal.dot(p); }
  bool operator==(const Halfspace&) const = default;
};

}  // namespace halfspace
