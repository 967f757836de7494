#include <algorithm>

#include "block/blocks.h"
#include "geometry/numbers.h"

// Blocks of a snapshot are checked, so that no index leads out of an array and no number is none.

namespace halfspace {
namespace {

template <int D>
bool is_turn(const Rotation<D>& rotation) {
  const Tensor<D> turn = rotation.tensor();
  return (turn.transpose() * turn - Tensor<D>::Identity()).norm() <= 1e-6;
}

template <int D>
bool is_deformation(const Deformation<D>& deformation) {
  return is_positive(deformation.volume) && is_positive(deformation.least_moment) &&
         is_positive(deformation.yield) && deformation.gradient.allFinite() &&
         deformation.gradient.determinant() > 0 && deformation.rate.allFinite();
}

}  // namespace

template <int D>
bool Blocks<D>::is_consistent(std::int32_t material_count) const {
  const std::size_t slots = slot_count();
  const std::size_t sizes[] = {
      material.size(),  generation.size(),     position.size(), velocity.size(), force.size(),
      rotation.size(),  applied_force.size(),  spin.size(),     momentum.size(), torque.size(),
      mass.size(),      applied_torque.size(), inertia.size(),  radius.size(),   largest_face.size(),
      thickness.size(), outlines_.slot_count()};
  if (std::any_of(std::begin(sizes), std::end(sizes), [&](std::size_t size) { return size != slots; }))
    return false;
  if (angle.size() != (D == 2 ? slots : 0)) return false;
  Array<std::int32_t> living(kind.get_allocator().resource());
  for (std::size_t i = 0; i < slots; ++i) {
    if (kind[i] == BlockKind::none) continue;
    living.push_back(std::int32_t(i));
    if (kind[i] < BlockKind::fixed || kind[i] > BlockKind::affine) return false;
    if (material[i] < 0 || material[i] >= material_count) return false;
    const bool is_placed = position[i].allFinite() && is_turn<D>(rotation[i]);
    const bool moves = velocity[i].allFinite() && spin[i].allFinite() && momentum[i].allFinite();
    const bool is_driven = applied_force[i].allFinite() && applied_torque[i].allFinite();
    const bool resists = is_positive(mass[i]) && is_positive(inertia[i].least_moment());
    if (!(is_placed && moves && is_driven && resists)) return false;
    if (!is_positive(radius[i]) || !is_finite(thickness[i])) return false;
  }
  Array<std::uint8_t> is_taken(slots, 0, kind.get_allocator());
  const auto is_free = [&](std::int32_t slot) {
    return slot >= 0 && std::size_t(slot) < slots && !lives(std::size_t(slot)) &&
           !is_taken[std::size_t(slot)]++;
  };
  return std::int64_t(living.size()) == living_ && free_slots_.size() == slots - living.size() &&
         all(free_slots_, is_free) && outlines_.is_consistent(living) &&
         all(deformations_.all(), is_deformation<D>) &&
         deformations_.is_consistent(slots, [&](std::size_t slot) { return is_affine(slot); });
}

template bool Blocks<2>::is_consistent(std::int32_t) const;
template bool Blocks<3>::is_consistent(std::int32_t) const;

}  // namespace halfspace
