#include "world/world.h"

// External edits: settings.

namespace halfspace {

template <int D>
void World<D>::set_gravity(const Vector<D>& gravity) {
  model_.settings.gravity = gravity;
  state_.edit();
}

template <int D>
void World<D>::set_damping(double local_damping, double mass_damping) {
  model_.settings.local_damping = local_damping;
  model_.settings.mass_damping = mass_damping;
  state_.edit();
}

template <int D>
void World<D>::set_strength_factor(double factor) {
  model_.materials.laws().weaken(factor / state_.strength_factor);
  model_.blocks.bonds().weaken(factor / state_.strength_factor);
  state_.strength_factor = factor;
  state_.edit();
}

template <int D>
void World<D>::set_time_step(double time_step) {
  model_.settings.time_step = time_step;
  state_.edit();
}

#define HALFSPACE_MEMBERS(D)                             \
  template void World<D>::set_gravity(const Vector<D>&); \
  template void World<D>::set_damping(double, double);   \
  template void World<D>::set_strength_factor(double);   \
  template void World<D>::set_time_step(double);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
