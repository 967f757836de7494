#pragma once

#include <algorithm>
#include <cstdint>

#include "geometry/numbers.h"
#include "geometry/vector.h"

namespace halfspace {

/// Hooke's law of an isotropic material between Green-Lagrange strain and second Piola-Kirchhoff stress (St.
/// Venant-Kirchhoff): linear, and invariant to large rotations. For small strains, as in rock; a block
/// compressed to 0.58 of its length becomes unstable.
struct Elasticity {
  double lame = 0;  // first Lame constant, Pa; in plane stress its 2D equivalent
  double shear_modulus = 0;
  double damping_time = 0;  // s, Rayleigh's beta: viscous stress = damping_time * stiffness * strain rate

  // As the host gave it; no step reads these.
  double young_modulus = 0;  // Pa
  double poisson_ratio = 0;
  std::int32_t is_plane_stress = 0;
  std::int32_t reserved = 0;  // explicit padding of saved elasticities

  bool is_given() const { return shear_modulus > 0; }
  /// False for data of a damaged snapshot.
  bool is_consistent() const {
    return is_finite(lame) && is_nonnegative(shear_modulus) && is_nonnegative(damping_time) &&
           is_nonnegative(young_modulus) && is_finite(poisson_ratio) && is_plane_stress >= 0 &&
           is_plane_stress <= 1;
  }

  template <int D>
  Tensor<D> stress(const Tensor<D>& strain) const {
    return lame * strain.trace() * Tensor<D>::Identity() + 2 * shear_modulus * strain;
  }

  /// The inverse.
  template <int D>
  Tensor<D> strain(const Tensor<D>& stress) const {
    const double mean = lame / (D * lame + 2 * shear_modulus) * stress.trace();
    return (stress - mean * Tensor<D>::Identity()) / (2 * shear_modulus);
  }

  /// The largest ratio of twice the energy per volume to the squared norm of the strain.
  template <int D>
  double largest_stiffness() const {
    return 2 * shear_modulus + std::max(D * lame, 0.0);
  }
};

}  // namespace halfspace
