#pragma once

#include <cmath>

#include "geometry/vector.h"

namespace halfspace {

/// Cosine and sine of a turn in the plane. Number is a double, or TwoLanes for two turns.
template <class Number>
struct CosineAndSine {
  Number cosine;
  Number sine;
};

/// From the z and w of a quaternion whose squared length is 1 but for a deficit of at most 3e-6: the series
/// of its inverse is exact to rounding then, and faster than a division.
template <class Number>
CosineAndSine<Number> cosine_and_sine(const Number& z, const Number& w, const Number& deficit) {
  const Number inverse = (1.0 + deficit) + deficit * deficit;
  return {(w * w - z * z) * inverse, 2.0 * w * z * inverse};
}

/// A turn about the origin.
template <int D>
class Rotation;

/// In the plane: a unit complex number, cosine and sine. Kept as such, and advanced by a polynomial instead
/// of the C library's sine, so that a run has the same bits wherever the arithmetic is IEEE.
template <>
class Rotation<2> {
 public:
  double cosine = 1;
  double sine = 0;

  static Rotation from_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }

  Vector<2> operator*(const Vector<2>& v) const {
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
  }

  Rotation operator*(const Rotation& r) const {
    return {cosine * r.cosine - sine * r.sine, sine * r.cosine + cosine * r.sine};
  }

  Rotation inverse() const { return {cosine, -sine}; }

  /// This rotation followed by a further turn, brought back to unit length.
  Rotation turned_by(double angle) const {
    if (angle == 0) return *this;
    const Rotation next = small_turn(angle) * *this;
    // One Newton step of 1/sqrt(c^2 + s^2) at 1: the length is off by rounding only.
    const double correction = 1.5 - 0.5 * (next.cosine * next.cosine + next.sine * next.sine);
    return {next.cosine * correction, next.sine * correction};
  }

  Rotation(double c = 1, double s = 0) : cosine(c), sine(s) {}

 private:
  static Rotation small_turn(double angle) {
    constexpr double largest_for_the_series = 0.0625;  // the first neglected term is below 1e-18 there
    if (std::abs(angle) > largest_for_the_series) return from_angle(angle);
    const double q = angle * angle;
    const double s = angle * (1 - q / 6 * (1 - q / 20 * (1 - q / 42 * (1 - q / 72))));
    const double c = 1 - q / 2 * (1 - q / 12 * (1 - q / 30 * (1 - q / 56 * (1 - q / 90))));
    return {c, s};
  }
};

/// In space: the columns of its matrix are where it takes the axes.
template <>
class Rotation<3> {
 public:
  Rotation() = default;

  /// From a quaternion x, y, z, w that is of unit length to rounding or nearly so: what it is off is taken
  /// out.
  static Rotation from_quaternion(const double q[4]) {
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double inverse = 1 / (x * x + y * y + z * z + w * w);
    const double twice = 2 * inverse;
    Rotation rotation;
    rotation.columns_[0] = {(w * w + x * x - y * y - z * z) * inverse, twice * (x * y + w * z),
                            twice * (x * z - w * y)};
    rotation.columns_[1] = {twice * (x * y - w * z), (w * w - x * x + y * y - z * z) * inverse,
                            twice * (y * z + w * x)};
    rotation.columns_[2] = {twice * (x * z + w * y), twice * (y * z - w * x),
                            (w * w - x * x - y * y + z * z) * inverse};
    return rotation;
  }

  Vector<3> operator*(const Vector<3>& v) const {
    return v.x() * columns_[0] + v.y() * columns_[1] + v.z() * columns_[2];
  }

  Rotation operator*(const Rotation& r) const {
    Rotation product;
    for (int i = 0; i < 3; ++i) product.columns_[i] = *this * r.columns_[i];
    return product;
  }

  Rotation inverse() const {
    Rotation transposed;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) transposed.columns_[i][j] = columns_[j][i];
    return transposed;
  }

 private:
  Vector<3> columns_[3] = {Vector<3>::UnitX(), Vector<3>::UnitY(), Vector<3>::UnitZ()};
};

}  // namespace halfspace
