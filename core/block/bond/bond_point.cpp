#include "block/bond/bond_point.h"

namespace halfspace {
namespace {

double mixed(double of_opening, double of_slip) {
  return std::min(1.0, std::sqrt(of_opening * of_opening + of_slip * of_slip));
}

/// Normal stiffness: after softening the secant stiffness at the largest opening.
template <int D>
double normal_stiffness(const BondLaw& law, double opening, const BondPoint<D>& point) {
  if (opening <= 0) return law.normal_stiffness;
  if (point.is_broken()) return 0;
  if (point.widest <= law.opening_at_peak()) return law.normal_stiffness;
  return law.tensile_strength * (1 - point.damage) / point.widest;
}

/// The shear strength under this normal traction.
template <int D>
double shear_strength(const BondLaw& law, double normal, const BondPoint<D>& point) {
  const double left = 1 - point.damage;
  const double cohesion = law.residual_cohesion + left * (law.cohesion - law.residual_cohesion);
  const double tangent = law.residual_tan_friction + left * (law.tan_friction - law.residual_tan_friction);
  return std::max(cohesion - normal * tangent, 0.0);
}

/// The damage caused by the largest opening and by the slip so far.
template <int D>
double faded(const BondLaw& law, const BondPoint<D>& point) {
  const double peak = law.opening_at_peak(), end = law.opening_at_end(), slip_end = law.slip_at_end();
  const double of_opening =
      point.widest <= peak ? 0 : (point.widest >= end ? 1 : (point.widest - peak) / (end - peak));
  return mixed(of_opening, slip_end > 0 ? point.faded_slip / slip_end : 0);
}

template <int D>
void fail(BondPoint<D>& point, BondFailure by) {
  point.damage = 1;
  point.failure = by;
}

/// Tension first: where both criteria are met at once, the point fails in tension.
template <int D>
void judge(const BondLaw& law, double opening, double trial_shear, BondPoint<D>& point) {
  if (opening > law.opening_at_peak()) {
    if (law.opening_at_end() == 0) return fail(point, BondFailure::tension);
    point.widest = std::max(point.widest, opening);
    point.damage = std::max(point.damage, faded(law, point));
    if (point.is_broken()) return fail(point, BondFailure::tension);
  }
  const double normal = normal_stiffness(law, opening, point) * opening;
  const double excess = trial_shear - shear_strength(law, normal, point);
  if (excess <= 0) return;
  if (law.slip_at_end() == 0) return fail(point, BondFailure::shear);
  point.faded_slip += excess / law.shear_stiffness;
  point.damage = std::max(point.damage, faded(law, point));
  if (point.is_broken()) fail(point, BondFailure::shear);
}

}  // namespace

template <int D>
BondTraction<D> traction_of(const BondLaw& law, double opening, const Vector<D>& slip, bool is_held,
                            BondPoint<D>& point, Vector<D>& yielded) {
  const bool was_broken = point.is_broken();
  const double length = slip.norm(), trial_shear = law.shear_stiffness * length;
  const double trial_normal = normal_stiffness(law, opening, point) * opening;
  const double trial_energy = 0.5 * (trial_normal * opening + trial_shear * length);
  if (!was_broken && !is_held) judge(law, opening, trial_shear, point);

  BondTraction<D> traction;
  traction.normal = normal_stiffness(law, opening, point) * opening;
  const bool is_open = point.is_broken() && opening >= 0;
  const double strength = is_open ? 0 : shear_strength(law, traction.normal, point);
  const double shear = is_held && !was_broken ? trial_shear : std::min(trial_shear, strength);
  if (length > 0) traction.shear = (shear / length) * slip;
  yielded = slip - traction.shear / law.shear_stiffness;
  traction.energy = 0.5 * (traction.normal * opening + shear * shear / law.shear_stiffness);
  traction.breaks = point.is_broken() && !was_broken;
  if (was_broken) {
    // The work of the mean traction, as in the step, without the energy that the spring has gained.
    traction.friction_loss = 0.5 * (traction.shear - point.shear).dot(yielded);
  } else {
    traction.fracture_loss = trial_energy - traction.energy;
  }
  return traction;
}

template BondTraction<2> traction_of(const BondLaw&, double, const Vector<2>&, bool, BondPoint<2>&,
                                     Vector<2>&);
template BondTraction<3> traction_of(const BondLaw&, double, const Vector<3>&, bool, BondPoint<3>&,
                                     Vector<3>&);

}  // namespace halfspace
