#include <utility>

#include "force/potential/space/planned_force.h"
#include "narrow_phase/pair.h"
#include "world/world.h"

namespace halfspace {

template <int D>
double World<D>::reduced_mass(std::size_t a, std::size_t b) const {
  const auto inverse = [&](std::size_t i) { return blocks_.moves_freely(i) ? 1 / blocks_.mass[i] : 0; };
  return 1 / (inverse(a) + inverse(b));
}

namespace {

double edge_length(const Outline<2>& o, int i) { return (o.vertex(o.next(i)) - o.vertex(i)).norm(); }
double edge_length(const Outline<3>& o, int i) {
  return (o.vertex(o.topology->edge_end[i]) - o.vertex(o.topology->edge_start[i])).norm();
}

}  // namespace

template <int D>
double World<D>::mean_edge_length() const {
  double sum = 0;
  std::int64_t edges = 0;
  for (std::size_t slot = 0; slot < blocks_.slot_count(); ++slot) {
    if (!blocks_.lives(slot)) continue;
    const Outline<D> outline = blocks_.outline(std::int32_t(slot));
    for (int i = 0; i < outline.edge_count(); ++i) sum += edge_length(outline, i);
    edges += outline.edge_count();
  }
  return edges > 0 ? sum / double(edges) : 0;
}

template <int D>
double World<D>::potential_length() const {
  if (settings_.potential_length > 0) return settings_.potential_length;
  return fixed_length_ > 0 ? fixed_length_ : mean_edge_length();
}

/// Forces have been evaluated with it: from now on it stays, whatever becomes of the blocks.
template <int D>
void World<D>::fix_potential_length() {
  if (laws_.knows_potential()) fixed_length_ = potential_length();
}

/// How the blocks of a pair move against each other.
template <int D>
[[gnu::always_inline]] inline PairMotion<D> World<D>::motion_of(const Candidate<D>& pair,
                                                                Evaluation& evaluation) const {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  PairMotion<D> motion{blocks_.velocity[b] - blocks_.velocity[a], blocks_.position[b] - blocks_.position[a],
                       blocks_.spin[a], blocks_.spin[b]};
  if (blocks_.has_affine()) motion.strain_rates = strain_rates_of(a, b, evaluation);
  return motion;
}

template <int D>
const StrainRates<D>* World<D>::strain_rates_of(std::size_t a, std::size_t b, Evaluation& evaluation) const {
  const bool a_strains = blocks_.is_affine(a), b_strains = blocks_.is_affine(b);
  if (!a_strains && !b_strains) return nullptr;
  evaluation.strain_rates = {};
  if (a_strains) evaluation.strain_rates.of_a = blocks_.deformation(a).strain_rate;
  if (b_strains) evaluation.strain_rates.of_b = blocks_.deformation(b).strain_rate;
  return &evaluation.strain_rates;
}

/// The force of a contact by a law of springs.
template <int D>
[[gnu::always_inline]] inline PairLoad<D> World<D>::spring_load(Candidate<D>& pair, const Contact<D>& contact,
                                                                const SpringLaw& law, const Spring<D>& spring,
                                                                ShearSpring<D>& shear,
                                                                Evaluation& evaluation) const {
  Overlap<D> overlap;
  if (law.stiffness_kind == StiffnessKind::per_area) {
    const PlacedBlocks<D> at = blocks_.placed(pair.a, pair.b);
    overlap = overlap_of(at.a, at.b, at.to_b, contact);
  }
  bool bonded = pair.bonded;
  const PairLoad<D> load =
      spring.evaluate(contact, overlap, motion_of(pair, evaluation), shear, bonded, evaluation.energy);
  pair.bonded = bonded;
  return load;
}

/// For k_n / H = 1. In space by a plan, and steps make plans.
template <int D>
inline PotentialForce<D> World<D>::potential_between(Candidate<D>& pair, const PlacedBlocks<D>& at,
                                                     bool is_step) {
  if constexpr (D == 2) {
    return potential_force(at.a, at.b, at.to_b, potential_room_);
  } else {
    return planned_force(at.a, at.b, at.to_b, is_step, pair.plan, candidates_.plans(), potential_room_);
  }
}

/// The force of a contact by a law of potentials. Where the blocks share most, they touch the longest: that
/// is what is looked at first the next time.
template <int D>
PairLoad<D> World<D>::potential_load(Candidate<D>& pair, const SpringLaw& law, const Spring<D>& spring,
                                     ShearSpring<D>& shear, Evaluation& evaluation) {
  // Another law has left it: potentials hold nothing together.
  if (evaluation.elapsed > 0) pair.bonded = false;
  const PlacedBlocks<D> at = blocks_.placed(pair.a, pair.b);
  const PotentialForce<D> potential = potential_between(pair, at, evaluation.elapsed > 0);
  const double stiffness = law.normal_stiffness / evaluation.potential_length;
  const LineOfAction<D> line = line_of_action(potential, stiffness, at.to_b);
  if (line.energy > 0) remember_point(potential.centroid, pair.memory);
  const PairMotion<D> motion = motion_of(pair, evaluation);
  if (motion.strain_rates) evaluation.stretch = stretch_besides(line, potential, stiffness, at.to_b);
  return spring.evaluate(line, motion, shear, evaluation.energy);
}

/// Adds what a contact does to its two blocks, by the law of their materials: only one of springs reads it.
template <int D>
void World<D>::load_blocks(std::size_t candidate, const Contact<D>& contact, Evaluation& evaluation) {
  Candidate<D>& pair = candidates_.pairs()[candidate];
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const SpringLaw& law = law_of(pair);
  const bool is_damped = law.is_damped();
  const Spring<D> spring(law, is_damped ? reduced_mass(a, b) : 0, evaluation.elapsed);
  ShearSpring<D> no_shear;
  ShearSpring<D>& shear = candidates_.shear().empty() ? no_shear : candidates_.shear()[candidate];
  const PairLoad<D> load = law.is_potential() ? potential_load(pair, law, spring, shear, evaluation)
                                              : spring_load(pair, contact, law, spring, shear, evaluation);
  const Vector<D> to_b = blocks_.position[b] - blocks_.position[a];
  blocks_.force[a] -= load.contact.force;
  blocks_.force[b] += load.contact.force;
  blocks_.torque[a] += load.contact.torque_on_a();
  blocks_.torque[b] += load.contact.torque_on_b(to_b);
  forces_.push_back(load.contact);
  if (is_damped) {
    const ContactForce<D> dashpots = load.dashpots();
    dashpot_load_[a].add(-dashpots.force, dashpots.torque_on_a());
    dashpot_load_[b].add(dashpots.force, dashpots.torque_on_b(to_b));
  }
  if (blocks_.has_affine()) strain_blocks(pair, load, is_damped, evaluation);
}

/// Adds what a contact does to the strain of its blocks, where they have any.
template <int D>
void World<D>::strain_blocks(const Candidate<D>& pair, const PairLoad<D>& load, bool is_damped,
                             Evaluation& evaluation) {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const Stretch<D> stretch = std::exchange(evaluation.stretch, {});
  const auto virial = [&](const ContactForce<D>& on_b, const Vector<D>& centroid) {
    return virial_of<D>(on_b.force, on_b.point - centroid, on_b.couple, load.normal);
  };
  if (blocks_.is_affine(a)) {
    const Vector<D> here = Vector<D>::Zero();
    blocks_.deformation(a).virial += stretch.of_a - virial(load.contact, here);
    if (is_damped) blocks_.deformation(a).dashpot_virial -= virial(load.dashpots(), here);
  }
  if (blocks_.is_affine(b)) {
    const Vector<D> to_b = blocks_.position[b] - blocks_.position[a];
    blocks_.deformation(b).virial += stretch.of_b + virial(load.contact, to_b);
    if (is_damped) blocks_.deformation(b).dashpot_virial += virial(load.dashpots(), to_b);
  }
}

/// Rate of what a block loses to dashpots, by its present velocity.
template <int D>
double World<D>::dashpot_power(std::size_t i) const {
  if (dashpot_load_.empty()) return 0;
  const double pushed = dashpot_load_[i].force.dot(blocks_.velocity[i]);
  if (blocks_.is_affine(i)) {
    const Deformation<D>& deformation = blocks_.deformation(i);
    return -pushed - deformation.dashpot_virial.cwiseProduct(deformation.velocity_gradient()).sum();
  }
  return -pushed - dashpot_load_[i].torque.dot(blocks_.spin[i]);
}

template class World<2>;
template class World<3>;

}  // namespace halfspace
