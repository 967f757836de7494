#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/rotation.h"
#include "geometry/shape.h"
#include "geometry/vector.h"

namespace halfspace {

inline double mass_of(const Shape<2>& shape, double density) { return density * shape.area(); }
inline double mass_of(const Shape<3>& shape, double density) { return density * shape.volume(); }

// Bounds of masses and moments of inertia: within them neither these nor their products with velocities
// overflow or underflow.
constexpr double min_mass = 1e-300, min_inertia = 1e-300, largest_mass = 1e150, largest_inertia = 1e300;

/// A moment or tensor of inertia in the frame of the world.
template <int D>
using InertiaTensor = Eigen::Matrix<double, D == 2 ? 1 : 3, D == 2 ? 1 : 3>;

/// The moment or tensor of inertia about the centroid.
template <int D>
struct Inertia;

template <>
struct Inertia<2> {
  double moment = 0;

  static Inertia of(const Shape<2>& shape, double density) { return {density * shape.polar_moment()}; }
  static Inertia of(const InertiaTensor<2>& tensor) { return {tensor(0, 0)}; }

  InertiaTensor<2> tensor(const Rotation<2>&) const { return InertiaTensor<2>(moment); }

  Angular<2> momentum(const Angular<2>& spin, const Rotation<2>&) const { return moment * spin; }
  Angular<2> spin(const Angular<2>& momentum, const Rotation<2>&) const { return momentum / moment; }
  InertiaTensor<2> inverse(const Rotation<2>&) const { return InertiaTensor<2>(1 / moment); }
  double min_moment() const { return moment; }
  /// The largest inverse effective mass at a point of the shape due to rotation.
  double yield_at(const Vector<2>& arm) const { return arm.squaredNorm() / moment; }
};

template <>
struct Inertia<3> {
  Vector<3> moments = Vector<3>::Zero();  // principal
  Rotation<3> axes;                       // of the principal moments, in the frame of the shape

  /// Are all moments the same, to rounding, as those of a cube? Then each axis is a principal one.
  bool is_spherical() const {
    const double largest = moments.maxCoeff();
    return largest - moments.minCoeff() <= 0x1p-44 * largest;
  }

  static Inertia of(const Shape<3>& shape, double density);
  static Inertia of(const InertiaTensor<3>& tensor);

  InertiaTensor<3> tensor(const Rotation<3>& rotation) const {
    const Tensor<3> turned = (rotation * axes).tensor();
    return turned * moments.asDiagonal() * turned.transpose();
  }
  Angular<3> momentum(const Angular<3>& spin, const Rotation<3>& rotation) const {
    const Rotation<3> turned = rotation * axes;
    return turned * Vector<3>(moments.cwiseProduct(turned.inverse() * spin));
  }
  Angular<3> spin(const Angular<3>& momentum, const Rotation<3>& rotation) const;
  InertiaTensor<3> inverse(const Rotation<3>& rotation) const {
    const Tensor<3> turned = (rotation * axes).tensor();
    return turned * moments.cwiseInverse().asDiagonal() * turned.transpose();
  }
  double min_moment() const { return moments.minCoeff(); }
  /// The largest eigenvalue of X I^-1 X^T, with X the cross product matrix of the arm. X has rank 2, so its
  /// sum and product of eigenvalues suffice.
  double yield_at(const Vector<3>& arm) const {
    const Vector<3> inverse = moments.cwiseInverse();
    const Vector<3> square = (axes.inverse() * arm).cwiseAbs2();
    const double sum = square.sum() * inverse.sum() - square.dot(inverse);
    const double product = square.sum() * inverse.prod() * square.dot(moments);
    return 0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4 * product)));
  }
};

/// The moment or tensor of inertia of a mass at the end of an arm.
inline InertiaTensor<2> inertia_of_point(double mass, const Vector<2>& arm) {
  return InertiaTensor<2>(mass * arm.squaredNorm());
}
inline InertiaTensor<3> inertia_of_point(double mass, const Vector<3>& arm) {
  return mass * (arm.squaredNorm() * Tensor<3>::Identity() - arm * arm.transpose());
}

/// For the smallest principal moment.
template <int D>
bool is_within_bounds(double mass, const Inertia<D>& inertia) {
  const double moment = inertia.min_moment();
  return mass >= min_mass && mass <= largest_mass && moment >= min_inertia && moment <= largest_inertia;
}

}  // namespace halfspace
