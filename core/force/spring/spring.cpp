#include "force/spring/spring.h"

#include <algorithm>
#include <cmath>

#include "force/spring/joint_face.h"
#include "force/spring/point_springs.h"
#include "geometry/mean_distance.h"
#include "geometry/tolerances.h"

namespace halfspace {

namespace {

template <int D>
const Vector<D>& direction_of(const Contact<D>& contact, const PointSprings<D>&, bool) {
  return contact.normal;
}
template <int D>
const Vector<D>& direction_of(const Contact<D>& contact, const Pressure<D>& pressure, bool bonded) {
  return bonded && is_joint_face(contact) ? contact.normal : pressure.normal;
}

}  // namespace

template <int D>
double Spring<D>::viscosity(double share_of_critical, double stiffness) const {
  return share_of_critical == 0 ? 0 : 2 * share_of_critical * std::sqrt(stiffness * reduced_mass);
}

/// One spring at each point of the region (eq. 36), with a dashpot in parallel.
template <int D>
typename Spring<D>::NormalPart Spring<D>::normal_part(const Contact<D>& contact,
                                                      const PointSprings<D>& springs,
                                                      const PairMotion<D>& motion, bool bonded,
                                                      ContactEnergy& energy) const {
  NormalPart normal;
  normal.base = base_of(contact);
  Vector<D> weighted = Vector<D>::Zero(), weighted_viscous = Vector<D>::Zero();
  const double viscosity_of_all = viscosity(law.normal_damping, law.normal_stiffness);
  // The opening velocity is linear over the contact plane. In 2D its slope is of no use for two points.
  double opening_at_first = 0;
  Vector<D> slope = Vector<D>::Zero();
  if (D == 3 && law.normal_damping > 0) {
    opening_at_first = contact.normal.dot(motion.relative_at(contact.points[0]));
    slope = motion.opening_slope(contact.normal);
  }
  for (int i = 0; i < contact.point_count; ++i) {
    const double depth = -contact.gaps[i];
    if (depth < 0 && !bonded) continue;
    const double stiffness = springs.part[i] * law.normal_stiffness;
    const double elastic = stiffness * depth;
    energy.strain += 0.5 * elastic * depth;
    double viscous = 0;
    if (law.normal_damping > 0) {
      const Vector<D>& p = contact.points[i];
      const double opening = D == 2 ? contact.normal.dot(motion.relative_at(p))
                                    : opening_at_first + slope.dot(p - contact.points[0]);
      viscous = -springs.part[i] * viscosity_of_all * opening;
      if (!bonded) viscous = std::max(viscous, -elastic);  // no tension by a dashpot
      normal.viscous_force += viscous;
      weighted_viscous += viscous * contact.points[i];
    }
    normal.force += elastic + viscous;
    weighted += (elastic + viscous) * contact.points[i];
  }
  if (normal.force > 0 && !bonded) {
    normal.center = weighted / normal.force;
  } else {
    // A bond has tension at one end and compression at the other: without a centre it has a couple.
    normal.center = middle_of(contact);
    const Vector<D> moment_arm = weighted - normal.force * normal.center;
    normal.couple = moment(moment_arm, contact.normal);
  }
  if (law.normal_damping > 0) {
    const Vector<D> moment_arm = weighted_viscous - normal.viscous_force * normal.center;
    normal.viscous_couple = moment(moment_arm, contact.normal);
  }
  if constexpr (D == 3) {
    if (law.resists_shear()) {
      const LoadedPart part = loaded_part(contact, bonded);
      normal.middle = part.middle;
      normal.twist_radius = part.mean_distance;
      if (motion.strain_rates) normal.act_in_middle(contact.normal);
    }
  } else {
    normal.middle = normal.center;  // anywhere on the line of shear
  }
  return normal;
}

/// The stiffness per area times the pressure. The springs of an intact bond are distributed over its common
/// face.
template <int D>
typename Spring<D>::NormalPart Spring<D>::normal_part(const Contact<D>& contact, const Pressure<D>& pressure,
                                                      const PairMotion<D>& motion, bool bonded,
                                                      ContactEnergy& energy) const {
  NormalPart normal;
  Bed bed;
  if (bonded && is_joint_face(contact)) {
    const JointFace<D> face = joint_face(contact);
    normal.base = face.base;
    normal.center = normal.middle = face.center;
    normal.force = law.normal_stiffness * face.force;
    normal.couple = law.normal_stiffness * face.couple;
    energy.strain += 0.5 * law.normal_stiffness * face.depth_squared;
    bed.spread = face.spread;
  } else {
    normal.base = pressure.base;
    const Vector<D> way = pressure.way_to_center();
    normal.middle = pressure.middle;
    normal.center = pressure.middle + way;
    normal.force = law.normal_stiffness * pressure.normal_force();
    normal.couple = law.normal_stiffness * (pressure.couple() - moment(way, pressure.force));
    if (motion.strain_rates) normal.act_in_middle(pressure.normal);
    energy.strain += law.normal_stiffness * pressure.energy;
    bed.spread = pressure.spread;
    bed.unevenness = pressure.unevenness();
  }
  normal.twist_radius = mean_distance(bed.spread);
  bed.middle = normal.middle;
  bed.stiffness = law.normal_stiffness * normal.base;
  bed.reach = certain_reach_of_area;
  damp(direction_of(contact, pressure, bonded), motion, bonded, bed, normal);
  return normal;
}

/// Dashpots with the distribution of the springs: they damp the bed's opening and tilting. Without a bond
/// their tension is limited so that the centre of pressure stays within the bed: the springs' force is a
/// constant part with its centre in the middle and the rest at the certain extent of the bed, and the
/// constant part minus the dashpots' tension has its centre there, too.
template <int D>
void Spring<D>::damp(const Vector<D>& direction, const PairMotion<D>& motion, bool bonded, const Bed& bed,
                     NormalPart& normal) const {
  if (law.normal_damping == 0) return;
  const double opening = direction.dot(motion.relative_at(bed.middle));
  const Vector<D> slope = motion.opening_slope(direction), tilting = bed.spread * slope;
  double viscosity_here = viscosity(law.normal_damping, bed.stiffness);
  if (!bonded) {
    const double pull = opening + std::sqrt(std::max(slope.dot(tilting), 0.0)) / bed.reach;
    const double most = (1 - bed.unevenness) * normal.force;
    if (viscosity_here * pull > most) viscosity_here = most / pull;
  }
  const Vector<D> moment_arm = opening * (bed.middle - normal.center) + tilting;
  normal.viscous_force = -viscosity_here * opening;
  normal.viscous_couple = -viscosity_here * moment(moment_arm, direction);
  normal.force += normal.viscous_force;
  normal.couple += normal.viscous_couple;
}

template <int D>
typename Spring<D>::ShearTrial Spring<D>::shear_trial(const NormalPart& normal, const Vector<D>& direction,
                                                      const PairMotion<D>& motion,
                                                      ShearSpring<D>& spring) const {
  ShearTrial trial;
  if (!law.resists_shear()) return trial;
  trial.stiffness = whole_stiffness(law.shear_stiffness, normal);
  trial.velocity = slip_velocity(motion.relative_at(normal.middle), direction, motion, normal.twist_radius);
  trial.before = carried(spring, direction, motion, elapsed);
  if constexpr (D == 3) {
    if (law.is_potential() && normal.twist_radius > 0)
      move(spring, trial.before, normal.middle, normal.twist_radius, direction, motion, elapsed);
  }
  trial.force = trial.before;
  if (trial.stiffness < spring.stiffness) trial.force *= trial.stiffness / spring.stiffness;
  trial.force -= trial.stiffness * (elapsed * trial.velocity);
  return trial;
}

template <int D>
double Spring<D>::shear_limit(const NormalPart& normal, bool bonded) const {
  const double friction = std::max(normal.force, 0.0) * law.tan_friction;
  return bonded ? friction + law.cohesion * normal.base : friction;
}

template <int D>
bool Spring<D>::holds(const NormalPart& normal, const ShearTrial& trial) const {
  return !is_torn(normal) && trial.force.norm() <= shear_limit(normal, true);
}

/// A joint fails by its mean tension. Without tensile strength it does where its faces no longer touch: flush
/// faces have a gap or an overlap by rounding, and dashpots pull on closed faces, too.
template <int D>
bool Spring<D>::is_torn(const NormalPart& normal) const {
  if (law.tensile_strength > 0) return -normal.force > law.tensile_strength * normal.base;
  const double stiffness = whole_stiffness(law.normal_stiffness, normal);
  const double size = D == 2 ? normal.base : std::sqrt(normal.base);
  const double elastic = normal.force - normal.viscous_force;
  return -elastic > stiffness * touch_reach * size;
}

/// Incremental shear spring with the Mohr-Coulomb limit (eqs. 37-40), in the middle of the base: at a point
/// that moved with the pressure it would let a block that rolls turn about its normal, too. Where its
/// stiffness decreases, as with the area, the removed springs take their force and energy with them; where it
/// increases, only new slip is stiffer, and of the stored energy only the recoverable part counts (Elata and
/// Berryman 1996). So a spring never releases more than it stored.
template <int D>
typename Spring<D>::ShearPart Spring<D>::shear_force(const NormalPart& normal, const ShearTrial& trial,
                                                     const Vector<D>& direction, ShearSpring<D>& spring,
                                                     bool bonded, ContactEnergy& energy) const {
  const auto& [stiffness, velocity, before, stuck] = trial;
  const Shear<D> slip = elapsed * velocity;
  const double limit = shear_limit(normal, bonded), wanted = stuck.norm();
  Shear<D> force = stuck;
  const bool slides = wanted > limit;
  // Within the limit at rounding, too: a force that is evaluated again is the same.
  if (slides) force *= (1 - 2 * machine_epsilon) * limit / wanted;

  // Work that the spring does not store is lost.
  if (spring.stiffness == preloaded) spring.stiffness = stiffness;
  const double stored = shear_energy<D>(force, stiffness);
  const double put_in = -0.5 * (before + force).dot(slip);
  energy.friction_loss += put_in - (stored - energy_of(spring));
  energy.strain += stored;
  remember(spring, force, stiffness, direction);

  if (law.shear_damping == 0 || slides) return {force};
  Shear<D> total = force - viscosity(law.shear_damping, stiffness) * velocity;
  const double length = total.norm();
  if (length > limit) total *= limit / length;
  return {total, total - force};
}

/// The normal part, with the shear part limited by friction and bond.
template <int D>
PairLoad<D> Spring<D>::load(const NormalPart& normal, const ShearTrial& trial, const Vector<D>& direction,
                            ShearSpring<D>& spring, bool bonded, ContactEnergy& energy) const {
  PairLoad<D> load;
  load.contact = {normal.force * direction, normal.center, normal.couple};
  load.normal = direction;
  if (law.is_damped()) load.viscous = {normal.viscous_force * direction, normal.viscous_couple};
  if (!law.resists_shear()) return load;
  const ShearPart shear = shear_force(normal, trial, direction, spring, bonded, energy);
  const auto add = [&](const Shear<D>& part, auto& to) {
    const Vector<D> force = shear_vector(part, direction);
    to.force += force;
    if constexpr (D == 3)
      to.couple += twisting_moment(part, direction, normal.twist_radius) +
                   moment(normal.middle - normal.center, force);
  };
  add(shear.force, load.contact);
  if (law.shear_damping > 0) add(shear.viscous, load.viscous);
  return load;
}

template <int D>
template <class Base>
PairLoad<D> Spring<D>::evaluate(const Contact<D>& contact, const Base& base, const PairMotion<D>& motion,
                                ShearSpring<D>& spring, std::int32_t& bonded, ContactEnergy& energy) const {
  const ContactEnergy before = energy;
  Vector<D> direction = direction_of(contact, base, bonded);
  NormalPart normal = normal_part(contact, base, motion, bonded, energy);
  ShearTrial trial = shear_trial(normal, direction, motion, spring);
  if (bonded && !holds(normal, trial)) {
    // The bond fails: its stored energy is lost, and the compressed part continues without it.
    const double held = energy.strain - before.strain;
    bonded = false;
    energy = before;
    direction = direction_of(contact, base, bonded);
    normal = normal_part(contact, base, motion, bonded, energy);
    energy.friction_loss += held - (energy.strain - before.strain);
    trial = shear_trial(normal, direction, motion, spring);
  }

  return load(normal, trial, direction, spring, bonded, energy);
}

template <int D>
PairLoad<D> Spring<D>::evaluate(const LineOfAction<D>& line, const PairMotion<D>& motion,
                                ShearSpring<D>& spring, ContactEnergy& energy) const {
  NormalPart normal;
  normal.force = line.force;
  normal.couple = line.couple;
  normal.center = normal.middle = line.loading_point;
  normal.twist_radius = line.twist_radius;
  energy.strain += line.energy;
  damp(line.direction, motion, false,
       {line.stiffness, line.middle, line.spread, certain_reach_of_body, line.unevenness()}, normal);
  const ShearTrial trial = shear_trial(normal, line.direction, motion, spring);
  return load(normal, trial, line.direction, spring, false, energy);
}

template struct Spring<2>;
template struct Spring<3>;
#define HALFSPACE_EVALUATE(D, BASE)                                                              \
  template PairLoad<D> Spring<D>::evaluate(const Contact<D>&, const BASE&, const PairMotion<D>&, \
                                           ShearSpring<D>&, std::int32_t&, ContactEnergy&) const;
HALFSPACE_EVALUATE(2, PointSprings<2>)
HALFSPACE_EVALUATE(2, Pressure<2>)
HALFSPACE_EVALUATE(3, PointSprings<3>)
HALFSPACE_EVALUATE(3, Pressure<3>)
#undef HALFSPACE_EVALUATE

}  // namespace halfspace
