#pragma once

#include <algorithm>
#include <cmath>

namespace halfspace {

/// The limit of input numbers, such as coordinates of shapes: squares, and their products with a mass or a
/// stiffness, do not overflow. False for NaN.
constexpr double largest_number = 1e75;
inline bool is_within_limits(double value) { return std::abs(value) <= largest_number; }

/// The largest distance of a block from the origin of a world, in its bounding radii. Its position is then
/// rounded to 2^-21 of its radius. At thirty times that distance, small displacements of blocks in contact
/// are lost in rounding.
constexpr double farthest_place = 0x1p32;

// Checks of numbers from a snapshot, before they are used.

inline bool is_finite(double value) { return std::isfinite(value); }
inline bool is_positive(double value) { return value > 0 && std::isfinite(value); }
inline bool is_nonnegative(double value) { return value >= 0 && std::isfinite(value); }
inline bool is_fraction(double value, double most) { return value >= 0 && value <= most; }

template <class Values, class Condition>
bool all(const Values& values, Condition condition) {
  return std::all_of(values.begin(), values.end(), condition);
}

}  // namespace halfspace
