#pragma once

#include <Eigen/LU>
#include <cstdint>

#include "block/elasticity.h"
#include "geometry/finite.h"
#include "geometry/numbers.h"
#include "geometry/rotation.h"
#include "geometry/shape.h"
#include "geometry/tolerances.h"
#include "geometry/vector.h"

namespace halfspace {

/// Integral of r r^T over a shape, about its centroid.
inline Tensor<2> second_moment_of(const Shape<2>& shape) {
  const auto& m = shape.second_moment();
  return Tensor<2>{{m[0], m[2]}, {m[2], m[1]}};
}
inline Tensor<3> second_moment_of(const Shape<3>& shape) {
  const auto& m = shape.second_moment();
  return Tensor<3>{{m[0], m[3], m[5]}, {m[3], m[1], m[4]}, {m[5], m[4], m[2]}};
}

/// Bound of the condition number of a deformation gradient. Far beyond it a rotation would make the block
/// flat to rounding, and its faces would have no normals.
constexpr double largest_condition = 0x1p40;

template <int D>
double condition_of(const Tensor<D>& gradient) {
  return gradient.norm() * gradient.inverse().norm();
}

/// The deformation of an affine block, its rate and its loads. The gradient maps a point X of the shape's
/// frame to its arm from the centroid. With the centroid this is the block of 6 unknowns (Zheng et al. 2020,
/// section 2), in 3D of 12. The gradient replaces rotation and small strains, so the mass matrix, density
/// times the integral of X X^T, is exact and constant, and large rotations cause no strain.
template <int D>
struct Deformation {
  std::int32_t slot = -1;  // of the block
  std::int32_t reserved = 0;
  double volume = 0;           // of the shape
  double min_moment = 0;       // of the mass matrix
  double strain_mobility = 0;  // largest inverse effective mass over the points, minus 1 / mass
  Tensor<D> gradient = Tensor<D>::Identity();
  Tensor<D> rate = Tensor<D>::Zero();          // of the gradient
  Tensor<D> acceleration = Tensor<D>::Zero();  // of the gradient
  Tensor<D> mass_matrix = Tensor<D>::Identity();
  Tensor<D> inverse_mass_matrix = Tensor<D>::Identity();
  Tensor<D> prestrain = Tensor<D>::Zero();   // in the frame of the shape: initial strain of the block
  Vector<D> load_force = Vector<D>::Zero();  // resultant of the surface load
  Tensor<D> load = Tensor<D>::Zero();    // surface load: force times arm^T, arms in the frame of the shape
  Tensor<D> virial = Tensor<D>::Zero();  // of the contacts: force times arm^T
  Tensor<D> dashpot_virial = Tensor<D>::Zero();  // the part of it from dashpots
  Tensor<D> strain_rate = Tensor<D>::Zero();     // in the world's frame

  /// False for data of a damaged snapshot.
  bool is_consistent() const {
    return is_positive(volume) && is_positive(min_moment) && is_positive(strain_mobility) &&
           all_finite(gradient) && gradient.determinant() > 0 && all_finite(rate);
  }

  /// `since`: time in which the rate was constant.
  Tensor<D> velocity_gradient(double since = 0) const { return rate * (gradient - since * rate).inverse(); }
  /// Green-Lagrange strain.
  Tensor<D> strain() const { return 0.5 * (gradient.transpose() * gradient - Tensor<D>::Identity()); }
  /// Rate of that strain, for a rate of the gradient.
  Tensor<D> rate_of_strain(const Tensor<D>& gradient_rate) const {
    const Tensor<D> half = 0.5 * gradient.transpose() * gradient_rate;
    return half + half.transpose();
  }
  /// Second Piola-Kirchhoff stress, elastic and viscous.
  Tensor<D> inner_stress(const Elasticity& elasticity) const {
    return elasticity.stress<D>(strain() + prestrain + elasticity.damping_time * rate_of_strain(rate));
  }
  /// Cauchy stress, elastic.
  Tensor<D> stress(const Elasticity& elasticity) const {
    return gradient * elasticity.stress<D>(strain() + prestrain) * gradient.transpose() /
           gradient.determinant();
  }
  void set_stress(const Tensor<D>& wanted, const Elasticity& elasticity) {
    const Tensor<D> back = gradient.inverse();
    prestrain = elasticity.strain<D>(gradient.determinant() * back * wanted * back.transpose()) - strain();
  }

  Angular<D> angular_momentum() const { return moment(Tensor<D>(rate * mass_matrix * gradient.transpose())); }
  /// Kinetic energy of the motion relative to the centroid.
  double kinetic_energy() const { return 0.5 * rate.cwiseProduct(rate * mass_matrix).sum(); }
  double strain_energy(const Elasticity& elasticity) const {
    const Tensor<D> whole = strain() + prestrain;
    return 0.5 * volume * whole.cwiseProduct(elasticity.stress<D>(whole)).sum();
  }
  /// Power of the viscous stress of an earlier rate of the gradient.
  double damping_power(const Elasticity& elasticity, const Tensor<D>& earlier_rate) const {
    const Tensor<D> viscous = elasticity.stress<D>(rate_of_strain(earlier_rate));
    return volume * elasticity.damping_time * viscous.cwiseProduct(rate_of_strain(rate)).sum();
  }

  /// The acceleration of the gradient times the mass matrix. `torque` is external.
  Tensor<D> drive(const Angular<D>& torque, const Elasticity& elasticity) const {
    const Tensor<D> outer = virial + 0.5 * cross_tensor(torque);
    return outer * gradient.inverse().transpose() + load - volume * gradient * inner_stress(elasticity);
  }
};

/// The deformation of a new block: none.
template <int D>
Deformation<D> undeformed(const Shape<D>& shape, double density, std::int32_t slot);

/// The rotation nearest to a gradient, by its polar decomposition.
inline Rotation<2> rotation_of(const Tensor<2>& gradient) {
  const double cosine = gradient(0, 0) + gradient(1, 1), sine = gradient(1, 0) - gradient(0, 1);
  const double length = std::sqrt(cosine * cosine + sine * sine);
  return {cosine / length, sine / length};
}

/// Newton's iteration of the polar decomposition, which squares the stretch's deviation from 1 in each
/// iteration (Higham 1986).
inline Rotation<3> rotation_of(const Tensor<3>& gradient) {
  Tensor<3> turn = gradient;
  for (double change = 1; change > converged_change;) {
    const Tensor<3> next = 0.5 * (turn + turn.inverse().transpose());
    change = (next - turn).norm();
    turn = next;
  }
  return Rotation<3>::from_axes(turn.col(0), turn.col(1), turn.col(2)).straightened();
}

}  // namespace halfspace
