#pragma once

#include <cmath>

#include "geometry/vector.h"

namespace halfspace {

/// An axis-aligned box, empty at first.
template <int D>
struct Box {
  Vector<D> lower = Vector<D>::Constant(HUGE_VAL);
  Vector<D> upper = Vector<D>::Constant(-HUGE_VAL);

  void include(const Vector<D>& p) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  bool is_empty() const { return !(lower[0] <= upper[0]); }
  Vector<D> center() const { return 0.5 * (lower + upper); }
  double extent() const { return (upper - lower).maxCoeff(); }
  bool overlaps(const Box& other) const {
    return (lower.array() <= other.upper.array()).all() && (other.lower.array() <= upper.array()).all();
  }
};

}  // namespace halfspace
