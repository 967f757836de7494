#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/vector.h"

namespace halfspace {

/// From the z and w of a quaternion whose squared norm is 1 minus a deficit of at most 3e-6: then the series
/// of the inverse is accurate to rounding, and faster than a division.
template <class Number>
CosineAndSine<Number> cosine_and_sine(const Number& z, const Number& w, const Number& deficit) {
  const Number inverse = (1.0 + deficit) + deficit * deficit;
  return {(w * w - z * z) * inverse, 2.0 * w * z * inverse};
}

/// A rotation about the origin.
template <int D>
class Rotation;

/// In 2D: a unit complex number, cosine and sine.
template <>
class Rotation<2> {
 public:
  double cosine = 1;
  double sine = 0;

  static Rotation from_angle(double angle) {
    const auto [c, s] = cosine_and_sine_of(angle);
    return {c, s};
  }

  Vector<2> operator*(const Vector<2>& v) const {
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
  }

  Rotation operator*(const Rotation& r) const {
    return {cosine * r.cosine - sine * r.sine, sine * r.cosine + cosine * r.sine};
  }

  Rotation inverse() const { return {cosine, -sine}; }
  Tensor<2> tensor() const {
    Tensor<2> turn;
    turn << cosine, -sine, sine, cosine;
    return turn;
  }

  /// This rotation followed by a rotation by an angle, normalized.
  Rotation turned_by(const Angular<2>& turn) const {
    if (turn[0] == 0) return *this;
    const auto [c, s] = cosine_and_sine_of(turn[0]);
    const Rotation next = Rotation(c, s) * *this;
    // One Newton step of 1/sqrt(c^2 + s^2) at 1 leaves only rounding errors of the length.
    const double correction = 1.5 - 0.5 * (next.cosine * next.cosine + next.sine * next.sine);
    return {next.cosine * correction, next.sine * correction};
  }

  /// The shortest rotation from another rotation to this one.
  Angular<2> turn_since(const Rotation& before) const {
    const Rotation turn = *this * before.inverse();
    return Angular<2>(angle_at(turn.cosine, turn.sine));
  }

  /// The Rodrigues vector of that rotation: along its axis, the tangent of half its angle.
  Angular<2> half_tangent_since(const Rotation& before) const {
    const Rotation turn = *this * before.inverse();
    return Angular<2>(turn.sine / (1 + turn.cosine));
  }

  /// A bound of the distance between the images of a unit vector under both rotations.
  double farthest_from(const Rotation& other) const {
    return std::abs(cosine - other.cosine) + std::abs(sine - other.sine);
  }

  /// As a unit quaternion x, y, z, w. Its larger component is computed first, to avoid cancellation.
  void write_quaternion(double q[4]) const {
    const double larger = std::sqrt(0.5 * (1 + std::abs(cosine)));
    q[0] = q[1] = 0;
    q[2] = cosine >= 0 ? 0.5 * sine / larger : std::copysign(larger, sine);
    q[3] = cosine >= 0 ? larger : 0.5 * std::abs(sine) / larger;
  }

  Rotation(double c = 1, double s = 0) : cosine(c), sine(s) {}
};

/// In 3D: a matrix, whose columns are the images of the axes.
template <>
class Rotation<3> {
 public:
  Rotation() = default;

  /// From a quaternion x, y, z, w of nearly unit norm, which is normalized.
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

  Tensor<3> tensor() const {
    Tensor<3> columns;
    columns << columns_[0], columns_[1], columns_[2];
    return columns;
  }

  /// From the images of the axes: orthonormal and right-handed.
  static Rotation from_axes(const Vector<3>& x, const Vector<3>& y, const Vector<3>& z) {
    Rotation rotation;
    rotation.columns_[0] = x;
    rotation.columns_[1] = y;
    rotation.columns_[2] = z;
    return rotation;
  }

  /// The image of axis k.
  const Vector<3>& axis(int k) const { return columns_[k]; }

  /// This rotation followed by one about the direction of `turn`, by its length.
  Rotation turned_by(const Angular<3>& turn) const {
    const double angle = turn.norm();
    if (angle == 0) return *this;
    const auto [c, s] = cosine_and_sine_of(angle);
    const Vector<3> about = turn / angle;
    Rotation next;
    for (int i = 0; i < 3; ++i) {
      const Vector<3>& v = columns_[i];
      const Vector<3> along = about.dot(v) * about;
      next.columns_[i] = along + c * (v - along) + s * cross_product(about, v);
    }
    return next.straightened();
  }

  /// Rotates about the image of axis k, without normalization: see straightened().
  [[gnu::always_inline]] void turn_about_own_axis(int k, double angle) {
    const auto [c, s] = cosine_and_sine_of(angle);
    Vector<3>&first = columns_[(k + 1) % 3], &second = columns_[(k + 2) % 3];
    const Vector<3> turned = c * first + s * second;
    second = c * second - s * first;
    first = turned;
  }

  /// The nearest rotation, without the accumulated rounding: a Newton step of the polar decomposition.
  Rotation straightened() const {
    const Tensor<3> m = tensor();
    const Eigen::Matrix3d gram = m.transpose().lazyProduct(m);
    const Eigen::Matrix3d nearest = m.lazyProduct(1.5 * Eigen::Matrix3d::Identity() - 0.5 * gram);
    return from_axes(nearest.col(0), nearest.col(1), nearest.col(2));
  }

  /// The rotation vector from another rotation to this one, of well below half a turn.
  Angular<3> turn_since(const Rotation& before) const {
    const Rotation turn = *this * before.inverse();
    const Vector<3>&x = turn.columns_[0], &y = turn.columns_[1], &z = turn.columns_[2];
    const Vector<3> twice_sine(y.z() - z.y(), z.x() - x.z(), x.y() - y.x());
    const double sine = 0.5 * twice_sine.norm(), cosine = 0.5 * (x.x() + y.y() + z.z() - 1);
    return sine > 0 ? Angular<3>(angle_at(cosine, sine) / (2 * sine) * twice_sine) : Angular<3>::Zero();
  }

  /// The Rodrigues vector of that rotation: along its axis, the tangent of half its angle.
  Angular<3> half_tangent_since(const Rotation& before) const {
    Vector<3> twice_sine = Vector<3>::Zero();
    double traced = 0;  // 1 + 2 cosines
    for (int i = 0; i < 3; ++i) {
      twice_sine += cross_product(before.columns_[i], columns_[i]);
      traced += before.columns_[i].dot(columns_[i]);
    }
    return twice_sine / (1 + traced);
  }

  /// A bound of the distance between the images of a unit vector under both rotations.
  double farthest_from(const Rotation& other) const {
    return std::sqrt((columns_[0] - other.columns_[0]).squaredNorm() +
                     (columns_[1] - other.columns_[1]).squaredNorm() +
                     (columns_[2] - other.columns_[2]).squaredNorm());
  }

  /// As a unit quaternion x, y, z, w, with w >= 0 to rounding. The largest of its four components is computed
  /// first, to avoid cancellation.
  void write_quaternion(double q[4]) const {
    const Vector<3>&x = columns_[0], &y = columns_[1], &z = columns_[2];
    // Four times the square of each component.
    const double squares[] = {1 + x.x() - y.y() - z.z(), 1 - x.x() + y.y() - z.z(), 1 - x.x() - y.y() + z.z(),
                              1 + x.x() + y.y() + z.z()};
    const double xy = x.y() + y.x(), yz = y.z() + z.y(), zx = z.x() + x.z();
    const double wx = y.z() - z.y(), wy = z.x() - x.z(), wz = x.y() - y.x();
    const double products[4][4] = {{squares[0], xy, zx, wx},
                                   {xy, squares[1], yz, wy},
                                   {zx, yz, squares[2], wz},
                                   {wx, wy, wz, squares[3]}};
    const int largest = int(std::max_element(squares, squares + 4) - squares);
    const double scale = 0.5 / std::sqrt(squares[largest]);
    const double sign = products[largest][3] < 0 ? -1 : 1;
    for (int k = 0; k < 4; ++k) q[k] = sign * scale * products[largest][k];
  }

 private:
  Vector<3> columns_[3] = {Vector<3>::UnitX(), Vector<3>::UnitY(), Vector<3>::UnitZ()};
};

}  // namespace halfspace
