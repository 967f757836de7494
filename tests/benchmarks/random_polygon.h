#pragma once

#include <cmath>
#include <random>

#include "capi/handles.h"

namespace halfspace_benchmark {

using halfspace_test::Point;
using halfspace_test::Points;
using Random = std::mt19937_64;

inline constexpr double pi = 3.14159265358979323846;

inline double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Vertices on a circle about the origin, counter-clockwise, each off its regular place by up to a fifth of
/// the spacing: always strictly convex.
inline Points random_polygon(int vertices, double radius, Random& random) {
  Points polygon;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * pi * (i + uniform(random, -0.2, 0.2)) / vertices;
    polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon;
}

}  // namespace halfspace_benchmark
