#pragma once

#include <cmath>

namespace halfspace {

// Sine, cosine, tangent and arctangent by additions and multiplications alone. The results of the C library's
// functions differ between machines, and on one machine where the processor has fused multiply-adds.

/// Cosine and sine of a rotation in 2D. Number is a double, or TwoLanes for two rotations.
template <class Number>
struct CosineAndSine {
  Number cosine;
  Number sine;
};

/// For any finite angle, with an error below 0.8 ulp.
CosineAndSine<double> cosine_and_sine_of_large(double angle);

/// For any finite angle, with an error of at most 1.01 ulp. Angles as small as those of a time step use a
/// short polynomial.
inline CosineAndSine<double> cosine_and_sine_of(double angle) {
  constexpr double largest_for_the_series = 0.0625;  // the first neglected term is below 1e-18 there
  if (!(std::abs(angle) <= largest_for_the_series)) return cosine_and_sine_of_large(angle);
  const double q = angle * angle;
  // Multiplied by constants: divisions would be a chain of latencies.
  constexpr double c2 = 1 / 2.0, c4 = 1 / 24.0, c6 = 1 / 720.0, c8 = 1 / 40320.0, c10 = 1 / 3628800.0;
  constexpr double s3 = 1 / 6.0, s5 = 1 / 120.0, s7 = 1 / 5040.0, s9 = 1 / 362880.0;
  return {1 - q * (c2 - q * (c4 - q * (c6 - q * (c8 - q * c10)))),
          angle * (1 - q * (s3 - q * (s5 - q * (s7 - q * s9))))};
}

/// Tangent of a finite angle, with an error below 1 ulp.
double tangent_of(double angle);

/// The angle of the vector (x, y), from -pi to pi, with an error below 0.6 ulp. Products of x and y must
/// neither overflow nor underflow.
double angle_at(double x, double y);

/// The same where y >= 0, with an error below 3 ulp, in a quarter of the instructions.
double quick_angle_at(double x, double y);

}  // namespace halfspace
