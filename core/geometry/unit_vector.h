#pragma once

#include <cmath>

#include "geometry/vector.h"

namespace halfspace {

/// The power of two by which a vector is divided so that its largest coordinate is from 1 to 2. No digit
/// changes by that, and squares neither overflow nor vanish. 1 for the vector 0.
template <int D>
double power_of_two_in(const Vector<D>& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  return largest > 0 ? std::ldexp(1, std::ilogb(largest)) : 1;
}

/// The vector at unit length, whatever length it has; 0 if it is 0. Its own length overflows next to the
/// largest number and has hardly a digit among the least ones.
template <int D>
Vector<D> unit_vector(const Vector<D>& v) {
  return (v / power_of_two_in(v)).stableNormalized();
}

}  // namespace halfspace
