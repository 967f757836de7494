#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/vector.h"

namespace halfspace {

/// The mean distance from its centroid of the points of an ellipse whose mean of r r^T has this trace and
/// this determinant: a third of its perimeter over pi, by Ramanujan. So it is exact for a disc, and within 3
/// % for any rectangle.
inline double mean_distance(double trace, double determinant) {
  const double root = std::sqrt(std::max(determinant, 0.0));
  const double square = 4 * std::max(trace + 2 * root, 0.0);  // of the sum of both semi-axes
  return std::sqrt(square) - std::sqrt(3 * square + 16 * root) / 3;
}

/// The same for a figure in a plane in space.
inline double mean_distance(const Tensor<3>& spread) {
  const double trace = spread.trace();
  return mean_distance(trace, 0.5 * (trace * trace - spread.squaredNorm()));
}
/// Nothing twists in 2D.
inline double mean_distance(const Tensor<2>&) { return 0; }

}  // namespace halfspace
