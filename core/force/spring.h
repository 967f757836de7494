#pragma once

#include "detect/contact.h"
#include "force/law.h"
#include "force/overlap.h"

namespace halfspace {

/// How two blocks move: velocities of their centroids and angular velocities.
template <int D>
struct PairMotion;

template <>
struct PairMotion<2> {
  Vector<2> velocity;  // of b's centroid relative to a's
  Vector<2> to_b;
  double spin_a;
  double spin_b;

  /// Velocity of b's material relative to a's at a point given from a's centroid.
  Vector<2> relative_at(const Vector<2>& p) const {
    return velocity + spin_b * perpendicular(p - to_b) - spin_a * perpendicular(p);
  }
};

/// What a sliding contact remembers.
struct ShearSpring {
  /// Marks a force set from outside, whose energy the next evaluation finds without booking a loss.
  static constexpr double preloaded = -1;

  double force = 0;   // on b, along the tangent perpendicular(normal)
  double energy = 0;  // stored
};

template <int D>
struct ContactForce;

template <>
struct ContactForce<2> {
  Vector<2> point{0, 0};    // where it acts, relative to the centroid of a
  double normal_force = 0;  // along the contact's normal, on b: compression > 0
  double shear_force = 0;   // along the tangent, perpendicular(normal), on b

  Vector<2> on_b(const Vector<2>& normal) const {
    return normal_force * normal + shear_force * perpendicular(normal);
  }
};

/// What a contact does to its two blocks.
template <int D>
struct PairLoad;

template <>
struct PairLoad<2> {
  ContactForce<2> contact;
  Vector<2> force;  // on b, opposite on a
  double torque_on_a;
  double torque_on_b;
};

/// Energies that a contact stores and has lost in this evaluation.
struct ContactEnergy {
  double strain = 0;
  double friction_loss = 0;
  double damping_loss = 0;
};

/// Penalty force of a contact (Wang et al. 2021, eqs. 36-40). Stateless but for the shear spring and the
/// bond.
class Spring {
 public:
  /// `overlap` is read only by a law per area; `elapsed` is the time over which the shear spring grows.
  Spring(const SpringLaw& law, double reduced_mass, double elapsed)
      : law_(law), reduced_mass_(reduced_mass), elapsed_(elapsed) {}

  PairLoad<2> evaluate(const Contact<2>& contact, const Overlap& overlap, const PairMotion<2>& motion,
                       ShearSpring& shear, bool& bonded, ContactEnergy& energy) const;

 private:
  struct NormalPart {
    double force = 0;
    double stiffness = 0;
    double width = 0;   // of the region: what cohesion and shear stiffness per area act on
    double couple = 0;  // on b, besides the force at the centre
    Vector<2> center{0, 0};
  };

  NormalPart per_contact(const Contact<2>& contact, const PairMotion<2>& motion, bool bonded,
                         ContactEnergy& energy) const;
  NormalPart per_area(const Contact<2>& contact, const Overlap& overlap, const PairMotion<2>& motion,
                      bool bonded, ContactEnergy& energy) const;
  NormalPart bonded_per_area(const Contact<2>& contact, ContactEnergy& energy) const;
  double shear_force(const NormalPart& normal, double slip_velocity, ShearSpring& shear, bool& bonded,
                     ContactEnergy& energy) const;
  double viscosity(double share_of_critical, double stiffness) const;

  const SpringLaw& law_;
  double reduced_mass_;
  double elapsed_;
};

}  // namespace halfspace
