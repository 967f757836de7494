#pragma once

#include <algorithm>

#include "geometry/numbers.h"
#include "geometry/vector.h"

namespace halfspace {

/// Hooke's law of an isotropic material between Green's strain and the second Piola stress (St. Venant and
/// Kirchhoff): linear, and blind to rotation however large. For strains as those of rock; squeezed to 0.58 of
/// its length a block gives way.
struct Elasticity {
  double lame = 0;  // first of Lame's constants, Pa; in plane stress that which the plane sees
  double shear_modulus = 0;
  double damping_time = 0;  // s: of the stress by strain rate to that by strain (Rayleigh's beta)

  bool is_given() const { return shear_modulus > 0; }
  /// False for what none can be, after reading a snapshot.
  bool is_consistent() const {
    return is_finite(lame) && is_nonnegative(shear_modulus) && is_nonnegative(damping_time);
  }

  template <int D>
  Tensor<D> stress(const Tensor<D>& strain) const {
    return lame * strain.trace() * Tensor<D>::Identity() + 2 * shear_modulus * strain;
  }

  /// The other way round.
  template <int D>
  Tensor<D> strain(const Tensor<D>& stress) const {
    const double mean = lame / (D * lame + 2 * shear_modulus) * stress.trace();
    return (stress - mean * Tensor<D>::Identity()) / (2 * shear_modulus);
  }

  /// No strain of length 1 has more energy per volume than half of it.
  template <int D>
  double largest_stiffness() const {
    return 2 * shear_modulus + std::max(D * lame, 0.0);
  }
};

}  // namespace halfspace
