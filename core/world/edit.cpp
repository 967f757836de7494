#include <algorithm>

#include "world/world.h"

namespace halfspace {

template <int D>
World<D>::World(const WorldSettings<D>& settings, Memory* memory)
    : settings_(settings),
      density_(memory),
      elasticity_(memory),
      fresh_(memory),
      laws_(memory),
      blocks_(memory),
      candidates_(memory),
      touching_(memory),
      forces_(memory),
      dashpot_load_(memory),
      potential_room_(memory),
      impact_room_(memory),
      hardness_(memory),
      acceleration_(memory),
      momentum_rate_(memory),
      next_rotation_(memory) {}

/// Every change of the world from outside: what it does to the energy is booked as outer work by prepare().
template <int D>
void World<D>::edit() {
  if (!edited_) residual_before_edit_ = ledger_.residual();
  edited_ = true;
}

template <int D>
std::int32_t World<D>::add_material(double density) {
  make_room_for_one(density_);
  make_room_for_one(elasticity_);
  laws_.add_material();
  density_.push_back(density);
  elasticity_.push_back({});
  edit();
  return std::int32_t(density_.size()) - 1;
}

template <int D>
void World<D>::change_laws() {
  candidates_.expire();  // shear springs may be needed now
  forget_contacts();
  edit();
}

template <int D>
void World<D>::set_default_law(const SpringLaw& law) {
  laws_.set_default(law);
  change_laws();
}

template <int D>
void World<D>::set_law(std::int32_t a, std::int32_t b, const SpringLaw& law) {
  laws_.set(a, b, law);
  change_laws();
}

template <int D>
std::int32_t World<D>::add_block(const Shape<D>& shape, BlockKind kind, std::int32_t material,
                                 const Vector<D>& position, const Rotation<D>& rotation) {
  make_room_for_one(fresh_);
  const std::int32_t slot = blocks_.add(shape, kind, material, density_[std::size_t(material)]);
  fresh_.resize(blocks_.slot_count());
  fresh_[std::size_t(slot)] = true;
  any_fresh_ = true;
  candidates_.expire();
  set_pose(slot, position, rotation);
  return slot;
}

template <int D>
void World<D>::remove_block(std::int32_t slot) {
  blocks_.remove(slot);
  // Its slot may come to name another block: no pair may remember it.
  candidates_.forget(slot);
  forget_contacts();
  edit();
}

template <int D>
void World<D>::set_pose(std::int32_t slot, const Vector<D>& position, const Rotation<D>& rotation) {
  blocks_.place(slot, position, rotation);
  candidates_.note_placement(blocks_, std::size_t(slot));
  forget_contacts();
  edit();
}

template <int D>
void World<D>::set_velocity(std::int32_t slot, const Vector<D>& velocity, const Angular<D>& spin) {
  blocks_.set_motion(slot, velocity, spin);
  edit();
}

template <int D>
void World<D>::set_elasticity(std::int32_t material, const Elasticity& elasticity) {
  elasticity_[std::size_t(material)] = elasticity;
  edit();
}

template <int D>
void World<D>::set_deformation(std::int32_t slot, const Tensor<D>& gradient, const Tensor<D>& rate) {
  blocks_.deform(slot, gradient, rate);
  candidates_.note_placement(blocks_, std::size_t(slot));
  forget_contacts();
  edit();
}

template <int D>
void World<D>::set_stress(std::int32_t slot, const Tensor<D>& stress) {
  const std::size_t s = std::size_t(slot);
  blocks_.deformation(s).set_stress(stress, elasticity_of(s));
  edit();
}

template <int D>
void World<D>::add_surface_load(std::int32_t slot, int face, const Vector<D>& traction) {
  const Face<D> loaded = blocks_.undeformed_face(slot, face);
  Deformation<D>& deformation = blocks_.deformation(std::size_t(slot));
  const Vector<D> force = loaded.area * traction;
  deformation.load_force += force;
  deformation.load += force * loaded.centroid.transpose();
  edit();
}

template <int D>
void World<D>::clear_surface_loads(std::int32_t slot) {
  Deformation<D>& deformation = blocks_.deformation(std::size_t(slot));
  deformation.load_force = Vector<D>::Zero();
  deformation.load = Tensor<D>::Zero();
  edit();
}

template <int D>
void World<D>::set_applied_force(std::int32_t slot, const Vector<D>& force, const Angular<D>& torque) {
  const std::size_t s = std::size_t(slot);
  if (blocks_.is_affine(s)) power_.outer += (torque - blocks_.applied_torque[s]).dot(blocks_.spin[s]);
  blocks_.applied_force[s] = force;
  blocks_.applied_torque[s] = torque;
  if (!edited_) accelerate(s);  // the next step begins under this force
}

template <int D>
bool World<D>::set_shear_force(std::size_t which, const Vector<D>& force) {
  if (!law_of(candidate_of(which)).resists_shear()) return false;
  // The energy is known at the next evaluation, which knows the stiffness.
  const Vector<D> normal = contact(which).normal;
  remember(candidates_.shear()[touching_[which]], shear_of(force, normal), preloaded, normal);
  edit();
  return true;
}

template class World<2>;
template class World<3>;

}  // namespace halfspace
