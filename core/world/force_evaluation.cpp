#include <algorithm>

#include "world/world.h"

namespace halfspace {

template <int D>
double World<D>::reduced_mass(std::size_t a, std::size_t b) const {
  const auto inverse = [&](std::size_t i) {
    return blocks_.kind[i] == BlockKind::rigid ? 1 / blocks_.mass[i] : 0;
  };
  return 1 / (inverse(a) + inverse(b));
}

template <int D>
void World<D>::evaluate_forces(double elapsed) {
  std::fill(blocks_.force.begin(), blocks_.force.end(), Vector<D>::Zero());
  std::fill(blocks_.torque.begin(), blocks_.torque.end(), 0.0);
  forces_.clear();
  ContactEnergy energy;
  ShearSpring no_shear;
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    Candidate& pair = candidates_.pairs()[candidate_[c]];
    const Contact<D>& contact = contacts_[c];
    const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
    const SpringLaw& law = laws_.between(blocks_.material[a], blocks_.material[b]);
    const PairMotion<D> motion{blocks_.velocity[b] - blocks_.velocity[a],
                               blocks_.position[b] - blocks_.position[a], blocks_.spin[a], blocks_.spin[b]};
    Overlap overlap;
    if (law.stiffness_kind == StiffnessKind::per_area) {
      overlap = measure_overlap(blocks_.outline(pair.a), blocks_.outline(pair.b), motion.to_b, contact.pair);
    }
    const bool is_damped = law.normal_damping > 0 || law.shear_damping > 0;
    const Spring spring(law, is_damped ? reduced_mass(a, b) : 0, elapsed);
    ShearSpring& shear = candidates_.shear().empty() ? no_shear : candidates_.shear()[candidate_[c]];
    bool bonded = pair.bonded;
    const PairLoad<D> load = spring.evaluate(contact, overlap, motion, shear, bonded, energy);
    pair.bonded = bonded;

    blocks_.force[a] -= load.force;
    blocks_.force[b] += load.force;
    blocks_.torque[a] += load.torque_on_a;
    blocks_.torque[b] += load.torque_on_b;
    forces_.push_back(load.contact);
  }
  ledger_.strain = energy.strain;
  ledger_.friction_loss += energy.friction_loss;
  ledger_.contact_damping_loss += energy.damping_loss;
}

template class World<2>;

}  // namespace halfspace
