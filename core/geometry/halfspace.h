#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// The points of non-negative depth; in 2D a half-plane. The normal points out of it.
template <int D>
struct Halfspace {
  Vector<D> normal;  // not 0, of any length: depths are scaled by it
  double offset;

  double depth(const Vector<D>& p) const { return offset - normal.dot(p); }
  bool operator==(const Halfspace&) const = default;
};

}  // namespace halfspace
