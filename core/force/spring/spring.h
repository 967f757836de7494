#pragma once

#include "force/law.h"
#include "force/pair_motion.h"
#include "force/potential/line_of_action.h"
#include "force/spring/point_springs.h"
#include "force/spring/pressure.h"
#include "force/spring/shear_spring.h"
#include "narrow_phase/contact.h"

namespace halfspace {

/// On b, and opposite on a.
template <int D>
struct ContactForce {
  Vector<D> force = Vector<D>::Zero();
  Vector<D> point = Vector<D>::Zero();     // of application, relative to the centroid of a
  Angular<D> couple = Angular<D>::Zero();  // with the force at the point
  double reserved = 0;                     // explicit padding in 2D, so that all saved bytes are defined

  Angular<D> torque_on_a() const { return -moment(point, force) - couple; }
  Angular<D> torque_on_b(const Vector<D>& to_b) const { return moment(point - to_b, force) + couple; }
};

/// The dashpots' part of a contact's force, at the same point.
template <int D>
struct DashpotForce {
  Vector<D> force;
  Angular<D> couple;

  static DashpotForce none() { return {Vector<D>::Zero(), Angular<D>::Zero()}; }
};

/// The load of a contact on its two blocks.
template <int D>
struct PairLoad {
  ContactForce<D> contact;
  Vector<D> normal;         // repulsion is along it, shear across it
  DashpotForce<D> viscous;  // unset unless the law is damped

  ContactForce<D> dashpots() const { return {viscous.force, contact.point, viscous.couple}; }
};

/// Energies that a contact stores, and has lost to friction in this evaluation. The dashpots' loss is
/// computed at the end of the step.
struct ContactEnergy {
  double strain = 0;
  double friction_loss = 0;

  void add(const ContactEnergy& more) {
    strain += more.strain;
    friction_loss += more.friction_loss;
  }
};

/// Force of a contact: by penalty (Wang et al. 2021, eqs. 36-40) or by potentials. Its only state is the
/// shear spring and the bond.
template <int D>
struct Spring {
  const ContactLaw& law;
  double reduced_mass;  // kg, of both blocks; unused unless the law is damped
  double elapsed;       // s, in which the shear spring grows

  /// The force of springs at points, with PointSprings as base, or per area, with Pressure as base: an intact
  /// bond of two faces has springs on its common face. `bonded` is 1 until the bond fails.
  template <class Base>
  PairLoad<D> evaluate(const Contact<D>& contact, const Base& base, const PairMotion<D>& motion,
                       ShearSpring<D>& spring, std::int32_t& bonded, ContactEnergy& energy) const;

  /// By the potentials of both blocks. The shear spring is at the loading point, across the line of action.
  PairLoad<D> evaluate(const LineOfAction<D>& line, const PairMotion<D>& motion, ShearSpring<D>& spring,
                       ContactEnergy& energy) const;

 private:
  struct NormalPart {
    double force = 0;
    double base = 0;                         // length or area, for cohesion and shear stiffness per area
    double twist_radius = 0;                 // mean distance of the base's points from its middle
    Angular<D> couple = Angular<D>::Zero();  // on b, with the force at the centre
    Vector<D> center = Vector<D>::Zero();
    Vector<D> middle = Vector<D>::Zero();            // of the base, where shear acts
    double viscous_force = 0;                        // the dashpots' part of the force
    Angular<D> viscous_couple = Angular<D>::Zero();  // and of the couple

    /// Where blocks strain, slip has the power of the shear only if this acts where the slip is measured.
    void act_in_middle(const Vector<D>& direction) {
      const Vector<D> way = center - middle;
      couple += moment(way, Vector<D>(force * direction));
      viscous_couple += moment(way, Vector<D>(viscous_force * direction));
      center = middle;
    }
  };

  /// Springs distributed over a part of the contact plane, each with a dashpot.
  struct Bed {
    double stiffness = 0;                  // of all
    Vector<D> middle = Vector<D>::Zero();  // centroid of the part
    Tensor<D> spread = Tensor<D>::Zero();  // mean of r r^T about the centroid
    double reach = 0;                      // certain extent of the part, in radii of gyration
    double unevenness = 0;                 // distance of the springs' centre from the middle, divided by that
  };

  struct ShearPart {
    Shear<D> force = Shear<D>::Zero();
    Shear<D> viscous = Shear<D>::Zero();  // the dashpots' part of the force
  };

  /// The shear spring without slip and failure.
  struct ShearTrial {
    double stiffness = 0;
    Shear<D> velocity = Shear<D>::Zero();
    Shear<D> before = Shear<D>::Zero();
    Shear<D> force = Shear<D>::Zero();
  };

  [[gnu::always_inline]] inline NormalPart normal_part(const Contact<D>& contact,
                                                       const PointSprings<D>& springs,
                                                       const PairMotion<D>& motion, bool bonded,
                                                       ContactEnergy& energy) const;
  NormalPart normal_part(const Contact<D>& contact, const Pressure<D>& pressure, const PairMotion<D>& motion,
                         bool bonded, ContactEnergy& energy) const;
  void damp(const Vector<D>& direction, const PairMotion<D>& motion, bool bonded, const Bed& bed,
            NormalPart& normal) const;
  [[gnu::always_inline]] inline ShearTrial shear_trial(const NormalPart& normal, const Vector<D>& direction,
                                                       const PairMotion<D>& motion,
                                                       ShearSpring<D>& spring) const;
  /// The stiffness of all springs of the base together.
  double whole_stiffness(double stiffness, const NormalPart& normal) const {
    return law.is_per_area() ? stiffness * normal.base : stiffness;
  }
  double shear_limit(const NormalPart& normal, bool bonded) const;
  bool holds(const NormalPart& normal, const ShearTrial& trial) const;
  bool is_torn(const NormalPart& normal) const;
  [[gnu::always_inline]] inline ShearPart shear_force(const NormalPart& normal, const ShearTrial& trial,
                                                      const Vector<D>& direction, ShearSpring<D>& spring,
                                                      bool bonded, ContactEnergy& energy) const;
  [[gnu::always_inline]] inline PairLoad<D> load(const NormalPart& normal, const ShearTrial& trial,
                                                 const Vector<D>& direction, ShearSpring<D>& spring,
                                                 bool bonded, ContactEnergy& energy) const;
  double viscosity(double share_of_critical, double stiffness) const;
};

extern template struct Spring<2>;
extern template struct Spring<3>;

}  // namespace halfspace
