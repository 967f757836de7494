#include <algorithm>

#include "block/blocks.h"
#include "geometry/numbers.h"

// The check of blocks that are read from a snapshot.

namespace halfspace {
namespace {

template <int D>
bool is_turn(const Rotation<D>& rotation) {
  const Tensor<D> turn = rotation.tensor();
  return (turn.transpose() * turn - Tensor<D>::Identity()).norm() <= 1e-6;
}

}  // namespace

template <int D>
bool Blocks<D>::is_consistent(std::int32_t material_count) const {
  const std::size_t slots = slot_count();
  const std::size_t sizes[] = {
      material.size(),  generation.size(),     position.size(),       velocity.size(), force.size(),
      rotation.size(),  applied_force.size(),  spin.size(),           momentum.size(), torque.size(),
      mass.size(),      applied_torque.size(), inertia.size(),        radius.size(),   largest_face.size(),
      thickness.size(), held.size(),           outlines_.slot_count()};
  if (std::any_of(std::begin(sizes), std::end(sizes), [&](std::size_t size) { return size != slots; }))
    return false;
  if (angle.size() != (D == 2 ? slots : 0) || moving_end_ < 0 || moving_end() > slots) return false;
  Array<std::int32_t> living(kind.get_allocator().resource());
  for (std::size_t i = 0; i < slots; ++i) {
    if (kind[i] == BlockKind::none) continue;
    if (moves(i) && i >= moving_end()) return false;
    living.push_back(std::int32_t(i));
    if (kind[i] < BlockKind::fixed || kind[i] > BlockKind::mesh) return false;
    if (material[i] < 0 || material[i] >= material_count) return false;
    const bool is_placed = all_finite(position[i]) && is_turn<D>(rotation[i]);
    // That of a deformable block follows from its deformation.
    const bool has_momentum = is_deformable(i) || all_finite(momentum[i]);
    const bool moves = all_finite(velocity[i]) && all_finite(spin[i]) && has_momentum;
    const bool is_driven = all_finite(applied_force[i]) && all_finite(applied_torque[i]);
    const bool resists = is_positive(mass[i]) && is_positive(inertia[i].min_moment());
    if (!(is_placed && moves && is_driven && resists)) return false;
    if (held[i] >= 2 << D || (held[i] != 0 && kind[i] != BlockKind::rigid)) return false;
    if (!is_positive(radius[i]) || !is_finite(thickness[i])) return false;
  }
  Array<std::uint8_t> is_taken(slots, 0, kind.get_allocator());
  const auto is_free = [&](std::int32_t slot) {
    return slot >= 0 && std::size_t(slot) < slots && !lives(std::size_t(slot)) &&
           !is_taken[std::size_t(slot)]++;
  };
  const auto has_its_outline = [&](std::int32_t slot) {
    return (own_outline(slot).vertex_count() == 0) == is_compound(std::size_t(slot));
  };
  const auto is_like_its_compound = [&](const Part<D>& part) {
    const BlockKind of_compound = kind[std::size_t(part.compound)];
    return of_compound != BlockKind::none && of_compound <= BlockKind::rigid &&
           kind[std::size_t(part.block)] == of_compound && is_turn<D>(part.pose.rotation);
  };
  const auto is_on_surface = [&](const SurfaceCell<D>& cell) {
    return std::size_t(cell.block) < slots && is_of_mesh(std::size_t(cell.block)) &&
           own_outline(cell.block).vertex_count() == D + 1;
  };
  const auto joins_living = [&](const Bond<D>& bond) {
    return bond.a < 0 || (lives(std::size_t(bond.a)) && lives(std::size_t(bond.b)));
  };
  return std::int64_t(living.size()) == living_ &&
         std::count(held.begin(), held.end(), 0) == std::ptrdiff_t(slots) - held_count_ &&
         free_slots_.size() == slots - living.size() && all(free_slots_, is_free) &&
         outlines_.is_consistent(living) && compounds_.is_consistent(slots) && all(living, has_its_outline) &&
         all(compounds_.parts(), is_like_its_compound) &&
         all(deformations_.all(), [](const Deformation<D>& d) { return d.is_consistent(); }) &&
         deformations_.is_consistent(slots, [&](std::size_t slot) { return is_deformable(slot); }) &&
         bonds_.is_consistent(slots) && all(bonds_.all(), joins_living) &&
         meshes_.is_consistent(material_count) && all(meshes_.surface(), is_on_surface) &&
         std::count(kind.begin(), kind.end(), BlockKind::mesh) == std::ptrdiff_t(meshes_.surface().size());
}

template bool Blocks<2>::is_consistent(std::int32_t) const;
template bool Blocks<3>::is_consistent(std::int32_t) const;

}  // namespace halfspace
