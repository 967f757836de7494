#pragma once

#include <cmath>

namespace halfspace_test {

/// The mean distance of a rectangle's points from its middle, by the midpoint rule.
inline double mean_distance_of_rectangle(double a, double b) {
  const int n = 400;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) sum += std::hypot(((i + 0.5) / n - 0.5) * a, ((j + 0.5) / n - 0.5) * b);
  return sum / (n * n);
}

}  // namespace halfspace_test
