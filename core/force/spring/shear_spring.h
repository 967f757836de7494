#pragma once

#include "force/pair_motion.h"
#include "geometry/vector.h"

namespace halfspace {

/// Shear of a contact, as a force on b or a slip of b relative to a: in 2D the component along the tangent
/// perpendicular(normal). In 3D a vector in the contact plane, and as a fourth component the twist about the
/// normal, at the mean distance of the base's points from its middle: a twist is a slip there, and a
/// twisting moment a force. A base that only twists has the moment of even pressure. So both share one
/// stiffness and one limit of friction, an ellipsoid (Howe and Cutkosky 1996).
template <int D>
using Shear = Vector<D == 2 ? 1 : 4>;

/// The state of a contact's shear spring.
template <int D>
struct ShearSpring;

/// Marks a force set by the user: the next evaluation sets its stiffness, without a loss.
constexpr double preloaded = -1;

template <>
struct ShearSpring<2> {
  Shear<2> force = Shear<2>::Zero();
  double stiffness = 0;  // of the spring with this force
};

template <>
struct ShearSpring<3> {
  Shear<3> force = Shear<3>::Zero();
  double stiffness = 0;                  // of the spring with this force
  Vector<3> normal = Vector<3>::Zero();  // of the contact plane of the force
  Vector<3> arm = Vector<3>::Zero();     // by potentials: from midway between the centroids to where it acts
  double reserved = 0;                   // explicit padding, so that all saved bytes are defined
};

/// The energy of a spring of this stiffness with this force.
template <int D>
double shear_energy(const Shear<D>& force, double stiffness) {
  return stiffness > 0 ? 0.5 * force.squaredNorm() / stiffness : 0;
}
template <int D>
double energy_of(const ShearSpring<D>& spring) {
  return shear_energy<D>(spring.force, spring.stiffness);
}

/// The stored force, rotated into the present contact plane. In 2D the tangent rotates with the contact, and
/// the scalar force is unchanged.
inline Shear<2> carried(const ShearSpring<2>& spring, const Vector<2>&, const PairMotion<2>&, double) {
  return spring.force;
}

/// In 3D the force rotates with the normal, by the smallest rotation, and with the mean spin of both blocks
/// about it.
Shear<3> carried(const ShearSpring<3>& spring, const Vector<3>& normal, const PairMotion<3>& motion,
                 double elapsed);

inline void remember(ShearSpring<2>& spring, const Shear<2>& force, double stiffness, const Vector<2>&) {
  spring = {force, stiffness};
}
inline void remember(ShearSpring<3>& spring, const Shear<3>& force, double stiffness,
                     const Vector<3>& normal) {
  spring.force = force;
  spring.stiffness = stiffness;
  spring.normal = normal;
}

/// The overlap of potentials has a centroid, but no base whose middle stays where it is. So the wrench of the
/// carried force is moved to the point: it gets the moment about the normal that it had where it acted. No
/// work is done, so the spring keeps its energy.
void move(ShearSpring<3>& spring, Shear<3>& force, const Vector<3>& point, double twist_radius,
          const Vector<3>& normal, const PairMotion<3>& motion, double elapsed);

/// Slip velocity at a point with the given velocity of b relative to a.
inline Shear<2> slip_velocity(const Vector<2>& velocity, const Vector<2>& normal, const PairMotion<2>&,
                              double) {
  return Shear<2>(perpendicular(normal).dot(velocity));
}
inline Shear<3> slip_velocity(const Vector<3>& velocity, const Vector<3>& normal, const PairMotion<3>& motion,
                              double twist_radius) {
  Shear<3> slip;
  slip << velocity - normal.dot(velocity) * normal, twist_radius * normal.dot(motion.spin_b - motion.spin_a);
  return slip;
}

/// The force of a shear in the contact plane.
inline Vector<2> shear_vector(const Shear<2>& shear, const Vector<2>& normal) {
  return shear[0] * perpendicular(normal);
}
inline Vector<3> shear_vector(const Shear<3>& shear, const Vector<3>&) { return shear.head<3>(); }

/// The inverse: the component in the contact plane of a force on b.
inline Shear<2> shear_of(const Vector<2>& force, const Vector<2>& normal) {
  return Shear<2>(perpendicular(normal).dot(force));
}
inline Shear<3> shear_of(const Vector<3>& force, const Vector<3>& normal) {
  Shear<3> shear;
  shear << force - normal.dot(force) * normal, 0;
  return shear;
}

/// The moment on b about the normal.
inline Angular<3> twisting_moment(const Shear<3>& shear, const Vector<3>& normal, double twist_radius) {
  return twist_radius * shear[3] * normal;
}

}  // namespace halfspace
