#include "world/motion/stable_step.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfspace {
namespace {

/// The largest contact area, in 2D width, of two blocks of this radius.
template <int D>
double largest_base(double radius) {
  return D == 2 ? 2 * radius : std::numbers::pi * radius * radius;
}

}  // namespace

/// The maximum stiffness of a contact of a block by a law.
template <int D>
double StableStep<D>::largest_stiffness(const ContactLaw& law, std::size_t slot,
                                        double potential_length) const {
  const double area = law.is_potential() ? largest_base<D>(blocks_.radius[slot]) : blocks_.largest_face[slot];
  return std::max(law.face_stiffness(area, potential_length), law.face_shear_stiffness(area));
}

/// The maximum stiffness and viscosity of any contact of a block: with a much heavier one.
template <int D>
typename StableStep<D>::StiffnessSum StableStep<D>::stiffest_contact(std::size_t slot,
                                                                     double potential_length) const {
  StiffnessSum hardest;
  for (std::int32_t other = 0; other < model_.materials.count(); ++other) {
    const ContactLaw& law = model_.materials.laws().between(blocks_.material[slot], other);
    const double stiffness = largest_stiffness(law, slot, potential_length);
    hardest.stiffness = std::max(hardest.stiffness, stiffness);
    hardest.viscosity = std::max(hardest.viscosity, law.viscosity(stiffness, blocks_.mass[slot]));
  }
  return hardest;
}

/// Stiffness and viscosity of an existing contact. The smaller block limits the stiffness; dashpots act on
/// the reduced mass.
template <int D>
typename StableStep<D>::StiffnessSum StableStep<D>::contact_stiffness_of(std::size_t c,
                                                                         double potential_length) const {
  const Candidate<D>& pair = contacts_.pair_of(c);
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const ContactLaw& law = model_.law_of(pair);
  StiffnessSum hardness;
  hardness.contacts = 1;
  hardness.stiffness =
      std::min(largest_stiffness(law, a, potential_length), largest_stiffness(law, b, potential_length));
  hardness.viscosity = law.is_damped() ? law.viscosity(hardness.stiffness, blocks_.reduced_mass(a, b)) : 0;
  return hardness;
}

template <int D>
typename StableStep<D>::StiffnessSum StableStep<D>::contact_stiffness_of(const Bond<D>& bond) const {
  const BondLaw& law = blocks_.bonds().law_of(bond);
  StiffnessSum hardness;  // contacts = 0: after failure, contacts may be added
  for (const BondPoint<D>& point : blocks_.bonds().points_of(bond))
    hardness.stiffness += point.area * std::max(law.normal_stiffness, law.shear_stiffness);
  return hardness;
}

/// Adds the stiffness of a bolt to both of its blocks. An arm beyond the block's radius has a larger
/// mobility.
template <int D>
void StableStep<D>::add_bolt(const Bolt<D>& bolt) {
  const auto moves = [&](std::int32_t slot) { return slot >= 0 && blocks_.moves_freely(std::size_t(slot)); };
  const double stiffness = stiffness_of(blocks_, bolt) * (moves(bolt.a) && moves(bolt.b) ? 2 : 1);
  const auto add = [&](std::int32_t slot, const Vector<D>& arm) {
    if (!moves(slot)) return;
    const std::size_t i = blocks_.mover_of(std::size_t(slot));
    const double ratio = (arm.norm() + blocks_.arm_of(std::size_t(slot)).norm()) / blocks_.radius[i];
    stiffness_of_block_[i].stiffness += stiffness * std::max(ratio * ratio, 1.0);
  };
  add(bolt.a, bolt.on_a);
  add(bolt.b, bolt.on_b);
}

/// The vibration of an affine block by itself, or of the mesh of a mesh block.
template <int D>
typename StableStep<D>::Wave StableStep<D>::wave_of(std::size_t slot) const {
  if (blocks_.is_of_mesh(slot)) {
    const Meshes<D>& meshes = blocks_.meshes();
    const Body<D>& body = meshes.body(meshes.surface_of_block(slot).body);
    return {body.squared_frequency, body.damping_time};
  }
  const Deformation<D>& deformation = blocks_.deformation(slot);
  const Elasticity& elasticity = model_.elasticity_of(slot);
  return {deformation.volume * elasticity.template largest_stiffness<D>() / deformation.min_moment,
          elasticity.damping_time};
}

/// Gershgorin: no frequency exceeds omega^2 = sum_contacts n K (1/m + y), and no decay rate exceeds gamma =
/// sum_contacts n c (1/m + y), with y = r^2/I of the point with the smallest effective mass, and n = 2, or 1
/// if the other block does not move freely. Dashpots and mass damping use the velocity of half a step before,
/// so central differences are stable if dt^2 omega^2 + 2 dt gamma < 4. A minimum number of contacts per block
/// accounts for contacts to come.
template <int D>
typename StableStep<D>::Limit StableStep<D>::limit() {
  // Mesh blocks share nodes with others, which count their own contacts.
  constexpr int min_contacts = 4, min_contacts_of_mesh = 1;
  const double length = model_.materials.laws().knows_potential() ? model_.potential_length() : 0;
  stiffness_of_block_.assign(blocks_.slot_count(), {});
  const auto add_to_both = [&](std::int32_t a, std::int32_t b, const StiffnessSum& hardness) {
    const int times = blocks_.moves_freely(std::size_t(a)) && blocks_.moves_freely(std::size_t(b)) ? 2 : 1;
    stiffness_of_block_[blocks_.mover_of(std::size_t(a))].add(hardness, times);
    stiffness_of_block_[blocks_.mover_of(std::size_t(b))].add(hardness, times);
  };
  for (std::size_t c = 0; c < contacts_.count(); ++c)
    add_to_both(contacts_.pair_of(c).a, contacts_.pair_of(c).b, contact_stiffness_of(c, length));
  for (const Bond<D>& bond : blocks_.bonds().all()) {
    if (bond.is_joint) add_to_both(bond.a, bond.b, contact_stiffness_of(bond));
  }
  for (const Bolt<D>& bolt : model_.bolts.all()) add_bolt(bolt);
  const double water = model_.water.unit_weight(model_.settings.gravity);
  Limit limit;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (!blocks_.moves_freely(i) || blocks_.is_part(i)) continue;
    StiffnessSum& all = stiffness_of_block_[i];
    if (!model_.water.empty()) all.stiffness += model_.water.stiffness_on(blocks_, i, water);
    const int least = blocks_.is_of_mesh(i) ? min_contacts_of_mesh : min_contacts;
    all.add(stiffest_contact(i, length), 2 * std::max(least - all.contacts, 0));
    const bool is_deformable = blocks_.is_deformable(i);
    const double mobility = 1 / blocks_.mass[i] + blocks_.strain_mobility(i);
    double omega_squared = all.stiffness * mobility;
    double gamma = all.viscosity * mobility;
    const double by_others = omega_squared;
    if (is_deformable) {
      const Wave wave = wave_of(i);
      omega_squared += wave.squared_frequency;
      if (wave.damping_time > 0) gamma += wave.damping_time * wave.squared_frequency;
    }
    // Mass damping acts as dashpots do, but alone it does not limit the time step.
    if (omega_squared > 0) gamma += model_.settings.mass_damping;
    const double step = 4 / (gamma + std::sqrt(gamma * gamma + 4 * omega_squared));
    if (step < limit.step) limit = {step, std::int32_t(i), omega_squared > 2 * by_others};
  }
  return limit;
}

template <int D>
typename StableStep<D>::StiffnessSum StableStep<D>::sum_over_contacts_of(std::int32_t block) const {
  const double length = model_.materials.laws().knows_potential() ? model_.potential_length() : 0;
  const auto is_of_block = [&](std::int32_t slot) {
    return blocks_.mover_of(std::size_t(slot)) == std::size_t(block);
  };
  StiffnessSum sum;
  for (std::size_t c = 0; c < contacts_.count(); ++c) {
    const Candidate<D>& pair = contacts_.pair_of(c);
    if (is_of_block(pair.a) || is_of_block(pair.b)) sum.add(contact_stiffness_of(c, length), 1);
  }
  return sum;
}

template <int D>
std::optional<typename StableStep<D>::Neighbor> StableStep<D>::stiffest_neighbor_of(
    std::int32_t block) const {
  const double length = model_.materials.laws().knows_potential() ? model_.potential_length() : 0;
  std::optional<Neighbor> stiffest;
  double most = 0;
  const auto is_of_block = [&](std::int32_t slot) {
    return blocks_.mover_of(std::size_t(slot)) == std::size_t(block);
  };
  const auto look = [&](std::int32_t a, std::int32_t b, std::int64_t bond, const StiffnessSum& hardness) {
    if (stiffest && hardness.stiffness <= most) return;
    stiffest = {is_of_block(a) ? b : a, bond};
    most = hardness.stiffness;
  };
  for (std::size_t c = 0; c < contacts_.count(); ++c) {
    const Candidate<D>& pair = contacts_.pair_of(c);
    if (is_of_block(pair.a) || is_of_block(pair.b)) look(pair.a, pair.b, -1, contact_stiffness_of(c, length));
  }
  const Array<Bond<D>>& bonds = blocks_.bonds().all();
  for (std::size_t i = 0; i < bonds.size(); ++i) {
    const Bond<D>& bond = bonds[i];
    if (bond.is_joint && (is_of_block(bond.a) || is_of_block(bond.b)))
      look(bond.a, bond.b, std::int64_t(i), contact_stiffness_of(bond));
  }
  return stiffest;
}

template class StableStep<2>;
template class StableStep<3>;

}  // namespace halfspace
