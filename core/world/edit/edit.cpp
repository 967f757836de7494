#include <algorithm>

#include "world/world.h"

namespace halfspace {

template <int D>
std::int32_t World<D>::add_material(double density) {
  const std::int32_t material = model_.materials.add(density);
  state_.edit();
  return material;
}

template <int D>
void World<D>::set_default_law(const ContactLaw& law) {
  model_.materials.laws().set_default(law.weaker_by(state_.strength_factor));
  state_.change_pairs();
}

template <int D>
void World<D>::set_law(std::int32_t a, std::int32_t b, const ContactLaw& law) {
  model_.materials.laws().set(a, b, law.weaker_by(state_.strength_factor));
  state_.change_pairs();
}

template <int D>
std::int32_t World<D>::add_block(const Shape<D>& shape, BlockKind kind, std::int32_t material,
                                 const Vector<D>& position, const Rotation<D>& rotation) {
  state_.contacts.make_room_for_block();
  const std::int32_t slot = model_.blocks.add(shape, kind, material, model_.materials.density(material));
  state_.note_added(slot);
  set_pose(slot, position, rotation);
  return slot;
}

template <int D>
void World<D>::remove_block(std::int32_t slot) {
  model_.actions.end_on_block(slot, model_.blocks);
  model_.blocks.is_compound(std::size_t(slot)) ? model_.blocks.remove_compound(slot)
                                               : model_.blocks.remove(slot);
  state_.forget_block(slot);
}

template <int D>
void World<D>::set_pose(std::int32_t slot, const Vector<D>& position, const Rotation<D>& rotation) {
  const Blocks<D>& blocks = model_.blocks;
  model_.blocks.place(slot, position, rotation);
  if (blocks.is_compound(std::size_t(slot))) {
    for (const Part<D>& part : blocks.compounds().parts_of(std::size_t(slot)))
      state_.contacts.neighbors().note_placement(blocks, std::size_t(part.block));
  } else {
    state_.contacts.neighbors().note_placement(blocks, std::size_t(slot));
  }
  state_.change_contacts();
}

template <int D>
void World<D>::set_velocity(std::int32_t slot, const Vector<D>& velocity, const Angular<D>& spin) {
  model_.blocks.set_motion(slot, velocity, model_.blocks.freed_turn(std::size_t(slot), spin));
  state_.edit();
}

template <int D>
bool World<D>::set_elasticity(std::int32_t material, const Elasticity& elasticity) {
  Meshes<D>& meshes = model_.blocks.meshes();
  const auto take = [&](const Elasticity& taken) {
    model_.materials.set_elasticity(material, taken);
    meshes.renew_elasticity(model_.materials.bulk());
  };
  const Elasticity before = model_.materials.elasticity(material);
  take(elasticity);
  bool is_bounded =
      all(meshes.bodies(), [](const Body<D>& body) { return is_finite(body.squared_frequency); });
  meshes.for_each_element([&](const auto& element) { is_bounded = is_bounded && element.is_finite(); });
  if (!is_bounded) {
    take(before);
    return false;
  }
  state_.edit();
  return true;
}

template <int D>
void World<D>::set_deformation(std::int32_t slot, const Tensor<D>& gradient, const Tensor<D>& rate) {
  model_.blocks.deform(slot, gradient, rate);
  state_.contacts.neighbors().note_placement(model_.blocks, std::size_t(slot));
  state_.change_contacts();
}

template <int D>
void World<D>::set_stress(std::int32_t slot, const Tensor<D>& stress) {
  const std::size_t s = std::size_t(slot);
  model_.blocks.deformation(s).set_stress(stress, model_.elasticity_of(s));
  state_.edit();
}

template <int D>
void World<D>::add_surface_load(std::int32_t slot, int face, const Vector<D>& traction) {
  const Face<D> loaded = model_.blocks.undeformed_face(slot, face);
  Deformation<D>& deformation = model_.blocks.deformation(std::size_t(slot));
  const Vector<D> force = loaded.area * traction;
  deformation.load_force += force;
  deformation.load += force * loaded.centroid.transpose();
  state_.edit();
}

template <int D>
void World<D>::clear_surface_loads(std::int32_t slot) {
  Deformation<D>& deformation = model_.blocks.deformation(std::size_t(slot));
  deformation.load_force = Vector<D>::Zero();
  deformation.load = Tensor<D>::Zero();
  state_.edit();
}

template <int D>
void World<D>::set_applied_force(std::int32_t slot, const Vector<D>& force, const Angular<D>& torque) {
  const std::size_t s = std::size_t(slot);
  state_.drop_shared_motion();
  if (force != model_.blocks.applied_force[s] || torque != model_.blocks.applied_torque[s])
    state_.sleep.wake_island_of(s, state_.clock.time());
  if (model_.blocks.is_affine(s) && state_.share.is_own(s))
    state_.ledger.add_outer_power((torque - model_.blocks.applied_torque[s]).dot(model_.blocks.spin[s]));
  model_.blocks.applied_force[s] = force;
  model_.blocks.applied_torque[s] = torque;
  if (!state_.is_edited()) state_.integrator.accelerate(s);  // the next step begins under this force
}

template <int D>
bool World<D>::set_shear_force(std::size_t which, const Vector<D>& force) {
  if (!model_.law_of(state_.contacts.pair_of(which)).resists_shear()) return false;
  // The next evaluation computes the energy from the stiffness.
  const Vector<D> normal = state_.contacts.contact(which).normal;
  remember(state_.contacts.shear_of(which), shear_of(force, normal), preloaded, normal);
  state_.edit();
  return true;
}

#define HALFSPACE_MEMBERS(D)                                                                            \
  template std::int32_t World<D>::add_material(double);                                                 \
  template void World<D>::set_default_law(const ContactLaw&);                                           \
  template void World<D>::set_law(std::int32_t, std::int32_t, const ContactLaw&);                       \
  template std::int32_t World<D>::add_block(const Shape<D>&, BlockKind, std::int32_t, const Vector<D>&, \
                                            const Rotation<D>&);                                        \
  template void World<D>::remove_block(std::int32_t);                                                   \
  template void World<D>::set_pose(std::int32_t, const Vector<D>&, const Rotation<D>&);                 \
  template void World<D>::set_velocity(std::int32_t, const Vector<D>&, const Angular<D>&);              \
  template bool World<D>::set_elasticity(std::int32_t, const Elasticity&);                              \
  template void World<D>::set_deformation(std::int32_t, const Tensor<D>&, const Tensor<D>&);            \
  template void World<D>::set_stress(std::int32_t, const Tensor<D>&);                                   \
  template void World<D>::add_surface_load(std::int32_t, int, const Vector<D>&);                        \
  template void World<D>::clear_surface_loads(std::int32_t);                                            \
  template void World<D>::set_applied_force(std::int32_t, const Vector<D>&, const Angular<D>&);         \
  template bool World<D>::set_shear_force(std::size_t, const Vector<D>&);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
