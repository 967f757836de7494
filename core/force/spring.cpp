#include "force/spring.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

Vector<2> middle_of(const Contact<2>& contact) {
  return contact.point_count == 2 ? Vector<2>(0.5 * (contact.points[0] + contact.points[1]))
                                  : contact.points[0];
}

}  // namespace

double Spring::viscosity(double share_of_critical, double stiffness) const {
  return share_of_critical == 0 ? 0 : 2 * share_of_critical * std::sqrt(stiffness * reduced_mass_);
}

/// One spring at each point of the region, the contact's stiffness shared among them (eq. 36).
Spring::NormalPart Spring::per_contact(const Contact<2>& contact, const PairMotion<2>& motion, bool bonded,
                                       ContactEnergy& energy) const {
  NormalPart normal;
  normal.stiffness = law_.normal_stiffness;
  normal.width = contact.length;
  Vector<2> weighted(0, 0);
  for (int i = 0; i < contact.point_count; ++i) {
    const double depth = -contact.gaps[i];
    if (depth < 0 && !bonded) continue;
    const double stiffness = contact.shares[i] * law_.normal_stiffness;
    const double elastic = stiffness * depth;
    double viscous = 0;
    if (law_.normal_damping > 0) {
      const double opening = contact.normal.dot(motion.relative_at(contact.points[i]));
      viscous = -contact.shares[i] * viscosity(law_.normal_damping, law_.normal_stiffness) * opening;
      if (!bonded) viscous = std::max(viscous, -elastic);  // a dashpot alone never pulls
      energy.damping_loss -= viscous * opening * elapsed_;
    }
    energy.strain += 0.5 * elastic * depth;
    // The energy of both springs, differentiated by the turn that moves stiffness from one to the other.
    const double rate = i == 0 ? contact.share_rate : -contact.share_rate;
    normal.couple -= 0.5 * law_.normal_stiffness * rate * depth * depth;
    normal.force += elastic + viscous;
    weighted += (elastic + viscous) * contact.points[i];
  }
  normal.center = middle_of(contact);
  if (normal.force > 0 && !bonded) {
    normal.center = weighted / normal.force;
  } else {
    // A bond pulls at one end and pushes at the other: what has no centre has a couple.
    const Vector<2> moment_arm = weighted - normal.force * normal.center;
    normal.couple += cross(moment_arm, contact.normal);
  }
  return normal;
}

/// An intact contact per area: the springs of the joint are spread over the faces that were one, and pull as
/// well as push.
Spring::NormalPart Spring::bonded_per_area(const Contact<2>& contact, ContactEnergy& energy) const {
  NormalPart normal;
  const double length = contact.length;
  const double mean = 0.5 * (contact.gaps[0] + contact.gaps[1]);
  const double difference = contact.gaps[1] - contact.gaps[0];
  normal.width = length;
  normal.stiffness = law_.normal_stiffness * length;
  normal.center = middle_of(contact);
  normal.force = -normal.stiffness * mean;
  const Vector<2> along = contact.points[1] - contact.points[0];
  normal.couple = -normal.stiffness * difference / 12 * cross(along, contact.normal);
  energy.strain += 0.5 * normal.stiffness * (mean * mean + difference * difference / 12);
  return normal;
}

/// The stiffness per area times the overlap area: the linear depth integrated over the region, moment
/// included.
Spring::NormalPart Spring::per_area(const Contact<2>& contact, const Overlap& overlap,
                                    const PairMotion<2>& motion, bool bonded, ContactEnergy& energy) const {
  NormalPart normal;
  if (bonded && contact.point_count == 2) {
    normal = bonded_per_area(contact, energy);
  } else {
    normal.width = overlap.width;
    normal.stiffness = law_.normal_stiffness * overlap.width;
    normal.center = overlap.center;
    normal.force = law_.normal_stiffness * overlap.area;
    energy.strain += 0.5 * law_.normal_stiffness * overlap.depth_squared;
  }
  if (law_.normal_damping > 0) {
    const double opening = contact.normal.dot(motion.relative_at(normal.center));
    double viscous = -viscosity(law_.normal_damping, normal.stiffness) * opening;
    if (!bonded) viscous = std::max(viscous, -normal.force);
    energy.damping_loss -= viscous * opening * elapsed_;
    normal.force += viscous;
  }
  return normal;
}

/// Incremental shear spring with Mohr-Coulomb's limit (eqs. 37-40). In the plane the tangent turns with the
/// contact, and the scalar force with it.
double Spring::shear_force(const NormalPart& normal, double slip_velocity, ShearSpring& shear, bool& bonded,
                           ContactEnergy& energy) const {
  const bool per_area = law_.stiffness_kind == StiffnessKind::per_area;
  const double stiffness = law_.shear_stiffness * (per_area ? normal.width : 1);
  const double slip = slip_velocity * elapsed_;
  const double friction = std::max(normal.force, 0.0) * law_.tan_friction;
  const double before = shear.force;
  double force = before - stiffness * slip;
  double limit = bonded ? friction + law_.cohesion * normal.width : friction;
  if (std::abs(force) > limit && bonded) {
    bonded = false;
    limit = friction;
  }
  const bool slides = std::abs(force) > limit;
  if (slides) force = std::copysign(limit, force);

  // What motion put in and the spring does not hold is lost.
  const auto energy_of = [&](double f) { return stiffness > 0 ? 0.5 * f * f / stiffness : 0; };
  if (shear.energy == ShearSpring::preloaded) shear.energy = energy_of(before);
  const double stored = energy_of(force);
  const double put_in = -0.5 * (before + force) * slip;
  energy.friction_loss += put_in - (stored - shear.energy);
  energy.strain += stored;
  shear = {force, stored};

  if (law_.shear_damping == 0 || slides) return force;
  const double viscous = -viscosity(law_.shear_damping, stiffness) * slip_velocity;
  const double total = std::clamp(force + viscous, -limit, limit);
  energy.damping_loss -= (total - force) * slip;
  return total;
}

PairLoad<2> Spring::evaluate(const Contact<2>& contact, const Overlap& overlap, const PairMotion<2>& motion,
                             ShearSpring& shear, bool& bonded, ContactEnergy& energy) const {
  const auto normal_part = [&] {
    return law_.stiffness_kind == StiffnessKind::per_area ? per_area(contact, overlap, motion, bonded, energy)
                                                          : per_contact(contact, motion, bonded, energy);
  };
  ContactEnergy before = energy;
  NormalPart normal = normal_part();
  if (bonded && -normal.force > law_.tensile_strength * normal.width) {
    // Torn: what the bond held is lost, what is still compressed goes on without it.
    const double held = energy.strain - before.strain;
    bonded = false;
    energy = before;
    normal = normal_part();
    energy.friction_loss += held - (energy.strain - before.strain);
  }

  ContactForce<2> force{normal.center, normal.force, 0};
  if (law_.resists_shear()) {
    const double slip_velocity = perpendicular(contact.normal).dot(motion.relative_at(normal.center));
    force.shear_force = shear_force(normal, slip_velocity, shear, bonded, energy);
  }
  const Vector<2> on_b = force.on_b(contact.normal);
  return {force, on_b, -cross(normal.center, on_b) - normal.couple,
          cross(normal.center - motion.to_b, on_b) + normal.couple};
}

}  // namespace halfspace
