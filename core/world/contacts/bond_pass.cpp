#include "world/contacts/bond_pass.h"

#include <Eigen/LU>
#include <algorithm>

#include "geometry/tolerances.h"

namespace halfspace {

/// The mean of the face normals in both blocks, so that the result does not depend on their order.
template <int D>
Vector<D> BondPass<D>::normal_of(const Bond<D>& bond) const {
  const auto seen = [&](std::int32_t block, const Vector<D>& normal) {
    const std::size_t i = std::size_t(block);
    if (!blocks_.is_deformable(i)) return Vector<D>(blocks_.rotation[i].tensor() * normal);
    return Vector<D>((blocks_.deformation(i).gradient.inverse().transpose() * normal).normalized());
  };
  return (seen(bond.a, bond.normal_a) + seen(bond.b, bond.normal_b)).normalized();
}

template <int D>
void BondPass<D>::load_blocks(const Bond<D>& bond, const Load& load) {
  const std::size_t a = std::size_t(bond.a), b = std::size_t(bond.b);
  blocks_.force[a] -= load.force;
  blocks_.force[b] += load.force;
  blocks_.torque[a] -= moment(load.on_a);
  blocks_.torque[b] += moment(load.on_b);
  if (blocks_.is_deformable(a)) blocks_.deformation(a).virial -= load.on_a;
  if (blocks_.is_deformable(b)) blocks_.deformation(b).virial += load.on_b;
}

template <int D>
void BondPass<D>::note_failure(std::int64_t bond, std::int64_t number, const BondPoint<D>& before,
                               const BondPoint<D>& after, const Vector<D>& position, const Vector<D>& normal,
                               double energy) {
  BondEvent<D> event;
  event.bond = bond;
  event.point = number;
  event.step = step_;
  event.failure = after.failure;
  event.time = time_;
  event.area = before.area;
  event.normal_traction = before.normal_traction;
  event.shear_traction = before.shear.norm();
  event.energy = energy;
  event.position = position;
  event.normal = normal;
  bonds_.add_event(event);
}

template <int D>
typename BondPass<D>::Placement BondPass<D>::placement_of(const Bond<D>& bond) const {
  const std::size_t a = std::size_t(bond.a), b = std::size_t(bond.b);
  return {normal_of(bond), blocks_.position[b] - blocks_.position[a], blocks_.gradient(a),
          blocks_.gradient(b), blocks_.rotation[a].tensor()};
}

/// The force acts at the midpoint between the positions of the point in both blocks, so it conserves angular
/// momentum.
template <int D>
void BondPass<D>::load_point(std::int64_t which, std::int64_t number, const Placement& at,
                             BondPoint<D>& point, Load& load, Hold& hold, BondEnergy& energy) {
  const Vector<D> on_a = at.frame_a * point.on_a, on_b = at.to_b + at.frame_b * point.on_b;
  const Vector<D> apart = on_b - on_a, middle = 0.5 * (on_a + on_b);
  const double opening = apart.dot(at.normal);
  const Vector<D> slip = apart - opening * at.normal;
  Vector<D> slid = at.turn_a * point.slid;
  slid -= slid.dot(at.normal) * at.normal;

  const Bond<D>& bond = bonds_.all()[std::size_t(which)];
  const BondPoint<D> before = point;
  Vector<D> yielded;
  const BondTraction<D> traction =
      traction_of<D>(bonds_.law_of(bond), opening, slip - slid, bonds_.are_held(), point, yielded);
  point.slid = at.turn_a.transpose() * (slid + yielded);
  point.normal_traction = traction.normal;
  point.shear = -traction.shear;
  // If the traction is not finite, the point keeps its state, and the force makes the step unstable.
  const bool is_of_numbers = point.is_consistent();
  if (!is_of_numbers) point = before;

  const Vector<D> force = -point.area * (traction.normal * at.normal + traction.shear);
  load.force += force;
  load.on_a += force * middle.transpose();
  load.on_b += force * (middle - at.to_b).transpose();
  energy.strain += point.area * traction.energy;
  energy.fracture_loss += point.area * traction.fracture_loss;
  energy.friction_loss += point.area * traction.friction_loss;
  hold.has_broken = hold.has_broken || (point.is_broken() && !before.is_broken());
  hold.is_closed = hold.is_closed || !point.is_broken() || opening < 0;
  hold.min_slip = std::min(hold.min_slip, point.is_broken() ? slip.norm() : 0);
  if (traction.breaks && is_of_numbers) {
    note_failure(which, number, before, point, blocks_.position[std::size_t(bond.a)] + middle, at.normal,
                 point.area * traction.fracture_loss);
  }
}

template <int D>
bool BondPass<D>::load(std::int64_t step, double time, BondEnergy& energy) {
  step_ = step;
  time_ = time;
  bool has_broken = false, has_come_apart = false;
  for (std::size_t which = 0; which < bonds_.all().size(); ++which) {
    Bond<D>& bond = bonds_.all()[which];
    if (!bond.is_joint) continue;
    const Placement at = placement_of(bond);
    Load load;
    Hold hold;
    std::int64_t number = 0;
    for (BondPoint<D>& point : bonds_.points_of(bond))
      load_point(std::int64_t(which), number++, at, point, load, hold, energy);
    load_blocks(bond, load);
    has_broken = has_broken || hold.has_broken;
    if (hold.is_closed && hold.min_slip <= slid_joint * bond.extent) continue;
    bond.is_joint = 0;
    bond.hands_over = 1;
    has_come_apart = true;
  }
  return (has_broken && bonds_.rings().look(bonds_.points())) || has_come_apart;
}

/// Adds up the forces of a pair's joints. The next evaluation computes the energy of the spring.
template <int D>
void BondPass<D>::hand_over(ContactList<D>& contacts) {
  for (Bond<D>& bond : bonds_.all()) {
    if (!bond.hands_over) continue;
    bond.hands_over = 0;
    Vector<D> shear = Vector<D>::Zero();
    for (const BondPoint<D>& point : bonds_.points_of(bond)) shear += point.area * point.shear;
    contacts.add_shear(bond.a, bond.b, shear, normal_of(bond));
  }
}

template class BondPass<2>;
template class BondPass<3>;

}  // namespace halfspace
