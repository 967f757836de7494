#pragma once

#include <algorithm>
#include <cmath>

namespace halfspace {

/// Numbers from outside are no larger, as the coordinates of shapes are: no square is infinite then, nor its
/// product with a mass or a stiffness. False for NaN.
constexpr double largest_number = 1e75;
inline bool is_within_limits(double value) { return std::abs(value) <= largest_number; }

/// The farthest from the origin that a block of a world may be put, in its bounding radii. There, its place
/// is rounded by 2^-21 of its radius. Thirty times farther off, a block that meets another one with small
/// steps does not move at all, as each is lost in rounding.
constexpr double farthest_place = 0x1p32;

// Numbers that were read from a snapshot are checked by these before they are computed with.

inline bool is_finite(double value) { return std::isfinite(value); }
inline bool is_positive(double value) { return value > 0 && std::isfinite(value); }
inline bool is_nonnegative(double value) { return value >= 0 && std::isfinite(value); }
inline bool is_fraction(double value, double most) { return value >= 0 && value <= most; }

template <class Values, class Condition>
bool all(const Values& values, Condition condition) {
  return std::all_of(values.begin(), values.end(), condition);
}

}  // namespace halfspace
