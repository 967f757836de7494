#pragma once

#include "geometry/numbers.h"

namespace halfspace {

/// The law of a bond and of its residual strength after failure: the Mohr-Coulomb criterion with a tension
/// cut-off, at each integration point. With a fracture energy, strength decreases linearly with opening and
/// slip; without one, it drops at once.
struct BondLaw {
  double normal_stiffness = 0;  // Pa/m
  double shear_stiffness = 0;   // Pa/m
  double tensile_strength = 0;  // Pa
  double cohesion = 0;          // Pa
  double tan_friction = 0;
  double residual_cohesion = 0;
  double residual_tan_friction = 0;
  double tensile_fracture_energy = 0;  // J/m^2, after the peak
  double shear_fracture_energy = 0;

  /// The opening at which tensile strength is reached, and at which it has dropped to 0.
  double opening_at_peak() const { return tensile_strength / normal_stiffness; }
  double opening_at_end() const {
    return tensile_fracture_energy > 0 && tensile_strength > 0
               ? opening_at_peak() + 2 * tensile_fracture_energy / tensile_strength
               : 0;
  }
  /// The slip after the peak at which only the residual strength is left.
  double slip_at_end() const {
    const double lost = cohesion - residual_cohesion;
    return shear_fracture_energy > 0 && lost > 0 ? 2 * shear_fracture_energy / lost : 0;
  }

  /// The same law with all strengths divided by a factor.
  BondLaw weaker_by(double factor) const {
    BondLaw weaker = *this;
    for (double* strength : {&weaker.tensile_strength, &weaker.cohesion, &weaker.tan_friction,
                             &weaker.residual_cohesion, &weaker.residual_tan_friction})
      *strength /= factor;
    return weaker;
  }

  /// False for data of a damaged snapshot.
  bool is_consistent() const {
    return is_positive(normal_stiffness) && is_positive(shear_stiffness) &&
           is_nonnegative(tensile_strength) && is_nonnegative(cohesion) && is_nonnegative(tan_friction) &&
           is_nonnegative(residual_cohesion) && is_nonnegative(residual_tan_friction) &&
           is_nonnegative(tensile_fracture_energy) && is_nonnegative(shear_fracture_energy);
  }
};

}  // namespace halfspace
