#include <Eigen/LU>

#include "world/world.h"

// External edits: water and bolts.

namespace halfspace {

template <int D>
void World<D>::set_water(WaterTable<D>&& table, double density) {
  model_.water.set(std::move(table), density);
  state_.edit();
}

template <int D>
std::int64_t World<D>::add_bolt(Bolt<D> bolt, const Vector<D>& at_a, const Vector<D>& at_b,
                                double pretension) {
  const auto in_frame = [&](std::int32_t slot, const Vector<D>& place) {
    return slot < 0 ? place : model_.blocks.in_frame_of(std::size_t(slot), place);
  };
  bolt.on_a = in_frame(bolt.a, at_a);
  bolt.on_b = in_frame(bolt.b, at_b);
  bolt.unstressed_length = (at_b - at_a).norm() - pretension / bolt.stiffness;
  bolt.elongation = pretension / bolt.stiffness;
  bolt.tension = pretension;
  const std::int64_t number = model_.bolts.add(bolt);
  state_.edit();
  return number;
}

template <int D>
void World<D>::remove_bolt(std::size_t index) {
  model_.bolts.remove(index);
  state_.edit();
}

#define HALFSPACE_MEMBERS(D)                                                                     \
  template void World<D>::set_water(WaterTable<D>&&, double);                                    \
  template std::int64_t World<D>::add_bolt(Bolt<D>, const Vector<D>&, const Vector<D>&, double); \
  template void World<D>::remove_bolt(std::size_t);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
