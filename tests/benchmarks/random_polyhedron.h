#pragma once

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "capi/handles.h"

namespace halfspace_benchmark {

using Triple = std::array<double, 3>;
using Corners = std::vector<Triple>;

/// 12 to 20 corners on a sphere of diameter 1: their hull is the block.
inline Corners random_corners(std::mt19937_64& random) {
  std::uniform_real_distribution<double> along(-1, 1), around(0, 2 * 3.14159265358979323846);
  Corners corners;
  for (int count = std::uniform_int_distribution<int>(12, 20)(random); count > 0; --count) {
    const double z = along(random), angle = around(random), r = std::sqrt(1 - z * z);
    corners.push_back({0.5 * r * std::cos(angle), 0.5 * r * std::sin(angle), 0.5 * z});
  }
  return corners;
}

inline hs_view view_of(const Corners& corners) {
  return {&corners[0][0], &corners[0][1], &corners[0][2], sizeof(Triple), std::int64_t(corners.size())};
}

inline halfspace_test::Shape hull(hs_context* context, const Corners& corners) {
  hs_shape* shape = nullptr;
  halfspace_test::require_ok(hs_polyhedron_create_hull(context, view_of(corners), &shape), context);
  return halfspace_test::Shape(shape);
}

}  // namespace halfspace_benchmark
