#pragma once

#include <cmath>

#include "geometry/vector.h"

namespace halfspace {

/// The power of two that scales the largest coordinate of a vector to 1 to 2; 1 for the zero vector. Scaling
/// by it is exact, and squares neither overflow nor underflow.
template <int D>
double power_of_two_in(const Vector<D>& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  return largest > 0 ? std::ldexp(1, std::ilogb(largest)) : 1;
}

/// The vector normalized, whatever its length; 0 if it is 0. Scaled first, as its own length could overflow
/// or be subnormal.
template <int D>
Vector<D> unit_vector(const Vector<D>& v) {
  return (v / power_of_two_in(v)).stableNormalized();
}

}  // namespace halfspace
