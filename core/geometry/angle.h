#pragma once

#include <cmath>

namespace halfspace {

// Sine, cosine, tangent and arctangent by additions and multiplications alone. The C library's have other
// bits on other machines, and even on one: it takes another way where the processor fuses multiply-adds.

/// Cosine and sine of a turn in the plane. Number is a double, or TwoLanes for two turns.
template <class Number>
struct CosineAndSine {
  Number cosine;
  Number sine;
};

/// The angle is any finite one; the result is off by less than 0.8 units in the last place.
CosineAndSine<double> cosine_and_sine_of_large(double angle);

/// The angle is any finite one; the result is off by at most 1.01 units. Angles as small as those of a time
/// step take a short polynomial.
inline CosineAndSine<double> cosine_and_sine_of(double angle) {
  constexpr double largest_for_the_series = 0.0625;  // the first neglected term is below 1e-18 there
  if (!(std::abs(angle) <= largest_for_the_series)) return cosine_and_sine_of_large(angle);
  const double q = angle * angle;
  // Products with constants: divisions would wait for one another.
  constexpr double c2 = 1 / 2.0, c4 = 1 / 24.0, c6 = 1 / 720.0, c8 = 1 / 40320.0, c10 = 1 / 3628800.0;
  constexpr double s3 = 1 / 6.0, s5 = 1 / 120.0, s7 = 1 / 5040.0, s9 = 1 / 362880.0;
  return {1 - q * (c2 - q * (c4 - q * (c6 - q * (c8 - q * c10)))),
          angle * (1 - q * (s3 - q * (s5 - q * (s7 - q * s9))))};
}

/// Tangent of a finite angle, off by less than 1 unit.
double tangent_of(double angle);

/// The angle from -pi to pi of the vector (x, y), off by less than 0.6 units. Its length is neither 0 nor so
/// small or large that products of x and y are out of range.
double angle_at(double x, double y);

}  // namespace halfspace
