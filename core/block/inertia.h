#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/rotation.h"
#include "geometry/shape.h"
#include "geometry/vector.h"

namespace halfspace {

inline double mass_of(const Shape<2>& shape, double density) { return density * shape.area(); }
inline double mass_of(const Shape<3>& shape, double density) { return density * shape.volume(); }

// Masses and moments of inertia within these bounds can be computed with: neither they nor their products
// with velocities vanish or are infinite.
constexpr double least_mass = 1e-300, least_inertia = 1e-300, largest_mass = 1e150, largest_inertia = 1e300;

/// How a block resists turning about its centroid.
template <int D>
struct Inertia;

template <>
struct Inertia<2> {
  double moment = 0;

  static Inertia of(const Shape<2>& shape, double density) { return {density * shape.polar_moment()}; }

  Angular<2> momentum(const Angular<2>& spin, const Rotation<2>&) const { return moment * spin; }
  Angular<2> spin(const Angular<2>& momentum, const Rotation<2>&) const { return momentum / moment; }
  double least_moment() const { return moment; }
  /// Acceleration of a point of the shape over the force there, at most, as far as it comes of turning.
  double yield_at(const Vector<2>& arm) const { return arm.squaredNorm() / moment; }
};

template <>
struct Inertia<3> {
  Vector<3> moments = Vector<3>::Zero();  // principal
  Rotation<3> axes;                       // of these, in the shape's frame

  static Inertia of(const Shape<3>& shape, double density);

  Angular<3> momentum(const Angular<3>& spin, const Rotation<3>& rotation) const {
    const Rotation<3> turned = rotation * axes;
    return turned * Vector<3>(moments.cwiseProduct(turned.inverse() * spin));
  }
  Angular<3> spin(const Angular<3>& momentum, const Rotation<3>& rotation) const {
    const Rotation<3> turned = rotation * axes;
    return turned * Vector<3>((turned.inverse() * momentum).cwiseQuotient(moments));
  }
  double least_moment() const { return moments.minCoeff(); }
  /// The largest eigenvalue of X I^-1 X^T, X the cross product with the arm: of rank 2, so that the sum of
  /// its eigenvalues and that of their products tell them.
  double yield_at(const Vector<3>& arm) const {
    const Vector<3> inverse = moments.cwiseInverse();
    const Vector<3> square = (axes.inverse() * arm).cwiseAbs2();
    const double sum = square.sum() * inverse.sum() - square.dot(inverse);
    const double product = square.sum() * inverse.prod() * square.dot(moments);
    return 0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4 * product)));
  }
};

/// The inertia is judged by its least principal moment.
template <int D>
bool is_within_bounds(double mass, const Inertia<D>& inertia) {
  const double moment = inertia.least_moment();
  return mass >= least_mass && mass <= largest_mass && moment >= least_inertia && moment <= largest_inertia;
}

}  // namespace halfspace
