#include "world/world.h"

namespace halfspace {

template <int D>
double World<D>::reduced_mass(std::size_t a, std::size_t b) const {
  const auto inverse = [&](std::size_t i) {
    return blocks_.kind[i] == BlockKind::rigid ? 1 / blocks_.mass[i] : 0;
  };
  return 1 / (inverse(a) + inverse(b));
}

/// Adds what a contact does to its two blocks.
template <int D>
void World<D>::load_blocks(std::size_t candidate, const Contact<D>& contact, double elapsed,
                           ContactEnergy& energy) {
  Candidate<D>& pair = candidates_.pairs()[candidate];
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const SpringLaw& law = laws_.between(blocks_.material[a], blocks_.material[b]);
  const PairMotion<D> motion{blocks_.velocity[b] - blocks_.velocity[a],
                             blocks_.position[b] - blocks_.position[a], blocks_.spin[a], blocks_.spin[b]};
  Overlap<D> overlap;
  if (law.stiffness_kind == StiffnessKind::per_area) {
    const PlacedBlocks<D> at = blocks_.placed(pair.a, pair.b);
    overlap = overlap_of(at.a, at.b, at.to_b, contact);
  }
  const bool is_damped = law.normal_damping > 0 || law.shear_damping > 0;
  const Spring<D> spring(law, is_damped ? reduced_mass(a, b) : 0, elapsed);
  ShearSpring<D> no_shear;
  ShearSpring<D>& shear = candidates_.shear().empty() ? no_shear : candidates_.shear()[candidate];
  bool bonded = pair.bonded;
  const PairLoad<D> load = spring.evaluate(contact, overlap, motion, shear, bonded, energy);
  pair.bonded = bonded;

  blocks_.force[a] -= load.force;
  blocks_.force[b] += load.force;
  blocks_.torque[a] += load.torque_on_a;
  blocks_.torque[b] += load.torque_on_b;
  forces_.push_back(load.contact);
}

template class World<2>;
template class World<3>;

}  // namespace halfspace
