#include "world/contacts/force_pass.h"

#include <algorithm>
#include <utility>

#include "force/spring/joint_face.h"
#include "narrow_phase/pair.h"

// Contact forces are computed in passes over arrays, chunk by chunk (docs/decisions/threads.md):
//
//   load    each pair in contact writes its own force, couple and energies
//   gather  each block adds up the loads of its pairs, in ascending order of pairs; a row of blocks skips
//           chunks of pairs without any of its own, so a worker reads little that others wrote
//   sums    the sums per chunk are added up in the order of chunks

namespace halfspace {

template <int D>
void ForcePass<D>::fit_rooms() {
  const LawTable& laws = model_.materials.laws();
  const bool is_damped = laws.any([](const ContactLaw& law) { return law.is_damped(); });
  dashpot_load_.resize(is_damped ? blocks_.slot_count() : 0);
  is_loaded_.assign(chunk_count(blocks_.slot_count(), blocks_per_strip), true);
  const std::size_t pairs = neighbors_.room();
  forces_.resize(pairs);
  dashpots_.resize(is_damped ? pairs : 0);
  virials_.resize(blocks_.has_deformable() ? pairs : 0);
  if (laws.any([](const ContactLaw& law) { return law.is_per_area(); })) {
    for (PressureRoom<D>& room : pressure_rooms_) room.reserve(blocks_.max_edges());
  }
  if (!laws.knows_potential()) return;
  for (PotentialRoom<D>& room : potential_rooms_) room.reserve(blocks_.max_edges());
}

template <int D>
typename ForcePass<D>::Evaluation ForcePass<D>::begin(double elapsed) const {
  return {elapsed, model_.materials.laws().knows_potential() ? model_.potential_length() : 0};
}

/// The relative motion of the blocks of a pair. After a motion, velocities are those of its middle. They are
/// turned to its end, where forces and arms are, by half of the pair's mean rotation: then two blocks that
/// turn as one, by any angle, have no relative motion.
template <int D>
PairMotion<D> ForcePass<D>::motion_of(const Candidate<D>& pair, Evaluation& evaluation) const {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const Array<Angular<D>>& spin = evaluation.elapsed > 0 ? blocks_.mean_spin : blocks_.spin;
  PairMotion<D> motion{blocks_.velocity[b] - blocks_.velocity[a], blocks_.position[b] - blocks_.position[a],
                       spin[a], spin[b]};
  motion.velocity += swept(motion.half_turn(evaluation.elapsed), motion.velocity);
  if (blocks_.has_deformable()) motion.strain_rates = strain_rates_of(a, b, evaluation);
  return motion;
}

template <int D>
const StrainRates<D>* ForcePass<D>::strain_rates_of(std::size_t a, std::size_t b,
                                                    Evaluation& evaluation) const {
  const bool a_strains = blocks_.is_deformable(a), b_strains = blocks_.is_deformable(b);
  if (!a_strains && !b_strains) return nullptr;
  evaluation.strain_rates = {};
  if (a_strains) evaluation.strain_rates.of_a = blocks_.deformation(a).strain_rate;
  if (b_strains) evaluation.strain_rates.of_b = blocks_.deformation(b).strain_rate;
  return &evaluation.strain_rates;
}

/// The load by a law per area. It does not use `contact`, but for a bond.
template <int D>
PairLoad<D> ForcePass<D>::pressure_load(Candidate<D>& pair, const Contact<D>& contact,
                                        const PlacedBlocks<D>& at, const ContactLaw& law,
                                        const Spring<D>& spring, ShearSpring<D>& shear,
                                        Evaluation& evaluation) {
  const Pressure<D> pressure = pressure_between(at.a, at.b, at.to_b, pair.witness.pair,
                                                pressure_rooms_[std::size_t(evaluation.worker)]);
  const PairLoad<D> load =
      spring.evaluate(contact, pressure, motion_of(pair, evaluation), shear, pair.bonded, evaluation.energy);
  if (pair.bonded && is_joint_face(contact)) {
    evaluation.peak_overlap = std::max(evaluation.peak_overlap, -contact.gap);
  } else if (!pressure.is_empty()) {
    evaluation.peak_overlap = std::max(evaluation.peak_overlap, pressure.depth);
    if (evaluation.elapsed > 0) {  // a force that is evaluated again has the same bits
      pair.witness.pair = pressure.face;
      remember_point(pressure.centroid, pair.witness);
    }
    if (blocks_.has_deformable())
      evaluation.stretch = stretch_besides(pressure, law.normal_stiffness, at.to_b);
  }
  return load;
}

/// The load by a potential law, which does not use `contact`. Caches the centroid of the overlap, which the
/// next detection tests first.
template <int D>
PairLoad<D> ForcePass<D>::potential_load(Candidate<D>& pair, const PlacedBlocks<D>& at, const ContactLaw& law,
                                         const Spring<D>& spring, ShearSpring<D>& shear,
                                         Evaluation& evaluation) {
  // A bond of another law ends: potential laws have no cohesion.
  if (evaluation.elapsed > 0) pair.bonded = false;
  const PotentialForce<D> potential =
      potential_force(at.a, at.b, at.to_b, potential_rooms_[std::size_t(evaluation.worker)]);
  const double stiffness = law.normal_stiffness / evaluation.potential_length;
  const LineOfAction<D> line = line_of_action(potential, stiffness, at.to_b);
  if (line.energy > 0) remember_point(potential.centroid, pair.witness);
  const PairMotion<D> motion = motion_of(pair, evaluation);
  if (motion.strain_rates) evaluation.stretch = stretch_besides(line, potential, stiffness, at.to_b);
  return spring.evaluate(line, motion, shear, evaluation.energy);
}

template <int D>
template <StiffnessKind kind>
void ForcePass<D>::load(std::size_t k, const Contact<D>& contact, Evaluation& evaluation) {
  Candidate<D>& pair = neighbors_.pairs()[k];
  const ContactLaw& law = model_.law_of(pair);
  evaluation.last_block = std::max(evaluation.last_block, pair.b);
  const bool is_damped = law.is_damped();
  const double reduced_mass = is_damped ? blocks_.reduced_mass(std::size_t(pair.a), std::size_t(pair.b)) : 0;
  const Spring<D> spring{law, reduced_mass, evaluation.elapsed};
  ShearSpring<D> no_shear;
  ShearSpring<D>& shear = neighbors_.shear().empty() ? no_shear : neighbors_.shear()[k];
  const PlacedBlocks<D> at = blocks_.placed(pair.a, pair.b);
  const PairLoad<D> load = [&] {
    if constexpr (kind == StiffnessKind::potential)
      return potential_load(pair, at, law, spring, shear, evaluation);
    else if constexpr (kind == StiffnessKind::per_area)
      return pressure_load(pair, contact, at, law, spring, shear, evaluation);
    else
      return spring.evaluate(contact, point_springs(at.a, at.b, at.to_b, contact),
                             motion_of(pair, evaluation), shear, pair.bonded, evaluation.energy);
  }();
  forces_[k] = load.contact;
  if (!dashpots_.empty()) dashpots_[k] = is_damped ? load.viscous : DashpotForce<D>::none();
  if (!virials_.empty()) virials_[k] = virials_of(pair, load, is_damped, evaluation);
}

/// Virials of the deformable blocks of a pair.
template <int D>
typename ForcePass<D>::Virials ForcePass<D>::virials_of(const Candidate<D>& pair, const PairLoad<D>& load,
                                                        bool is_damped, Evaluation& evaluation) const {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const Stretch<D> stretch = std::exchange(evaluation.stretch, {});
  const auto virial = [&](const ContactForce<D>& on_b, const Vector<D>& centroid) {
    return virial_of<D>(on_b.force, on_b.point - centroid, on_b.couple, load.normal);
  };
  Virials virials;
  if (blocks_.is_deformable(a)) {
    const Vector<D> here = Vector<D>::Zero();
    virials.on_a = stretch.of_a - virial(load.contact, here);
    if (is_damped) virials.of_dashpots_on_a = -virial(load.dashpots(), here);
  }
  if (blocks_.is_deformable(b)) {
    const Vector<D> to_b = blocks_.position[b] - blocks_.position[a];
    virials.on_b = stretch.of_b + virial(load.contact, to_b);
    if (is_damped) virials.of_dashpots_on_b = virial(load.dashpots(), to_b);
  }
  return virials;
}

template <int D>
void ForcePass<D>::gather(std::span<const PairSums> chunks) {
  const std::size_t blocks = blocks_.slot_count();
  // A few rows of blocks per worker, because each row visits all chunks of pairs.
  const bool is_shared = worker_count(threads_) > 1 && contacts_.count() > 4 * pairs_per_chunk;
  const std::size_t rows = is_shared ? 4 * std::size_t(worker_count(threads_)) : 1;
  // Rows of whole strips, so that only one worker writes the mark of a strip.
  const std::size_t in_row = (blocks / rows / blocks_per_strip + 1) * blocks_per_strip;
  for_each_chunk(threads_, blocks, in_row, [&](const Chunk& row) { gather_row(row.begin, row.end, chunks); });
  known_ = true;
}

/// Adds loads in ascending order of contacts. Pairs are sorted by their first blocks, so the loop ends early.
template <int D>
void ForcePass<D>::gather_row(std::size_t first, std::size_t last, std::span<const PairSums> chunks) {
  unload(first, last);
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    if (chunks[c].last_block < std::int32_t(first)) continue;
    const auto contacts = contacts_.touching_in(c);
    if (std::size_t(neighbors_.pairs()[contacts.front()].a) >= last) return;
    gather_contacts(first, last, contacts);
  }
}

template <int D>
void ForcePass<D>::gather_contacts(std::size_t first, std::size_t last,
                                   std::span<const std::uint32_t> contacts) {
  const bool is_damped = !dashpots_.empty(), has_deformable = !virials_.empty();
  const auto is_here = [&](std::size_t i) { return i - first < last - first; };
  for (const std::uint32_t k : contacts) {
    const Candidate<D>& pair = neighbors_.pairs()[k];
    const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
    const ContactForce<D>& load = forces_[k];
    const Vector<D> to_b = blocks_.position[b] - blocks_.position[a];
    const ContactForce<D> dashpots =
        is_damped ? ContactForce<D>{dashpots_[k].force, load.point, dashpots_[k].couple} : ContactForce<D>();
    if (is_here(a)) {
      is_loaded_[a / blocks_per_strip] = true;
      blocks_.force[a] -= load.force;
      blocks_.torque[a] += load.torque_on_a();
      if (is_damped) dashpot_load_[a].add(-dashpots.force, dashpots.torque_on_a());
      if (has_deformable) strain(a, virials_[k].on_a, virials_[k].of_dashpots_on_a);
    }
    if (is_here(b)) {
      is_loaded_[b / blocks_per_strip] = true;
      blocks_.force[b] += load.force;
      blocks_.torque[b] += load.torque_on_b(to_b);
      if (is_damped) dashpot_load_[b].add(dashpots.force, dashpots.torque_on_b(to_b));
      if (has_deformable) strain(b, virials_[k].on_b, virials_[k].of_dashpots_on_b);
    }
  }
}

/// The loss by dashpots is that of the compound, whose parts then have none.
template <int D>
void ForcePass<D>::load_compounds() {
  for (const Part<D>& part : blocks_.compounds().parts()) {
    const std::size_t p = std::size_t(part.block), c = std::size_t(part.compound);
    const Vector<D> arm = blocks_.position[p] - blocks_.position[c];
    blocks_.force[c] += blocks_.force[p];
    blocks_.torque[c] += blocks_.torque[p] + moment(arm, blocks_.force[p]);
    is_loaded_[c / blocks_per_strip] = true;
    if (dashpot_load_.empty()) continue;
    const DashpotLoad load = std::exchange(dashpot_load_[p], {});
    dashpot_load_[c].add(load.force, load.torque + moment(arm, load.force));
  }
}

/// Skips strips without loads, as on most of a large terrain. Bonds load blocks, too, but set no mark.
template <int D>
void ForcePass<D>::unload(std::size_t first, std::size_t last) {
  for (std::size_t begin = first; begin < last; begin += blocks_per_strip) {
    std::uint8_t& is_loaded = is_loaded_[begin / blocks_per_strip];
    if (is_loaded || !blocks_.bonds().empty()) unload_strip(begin, std::min(begin + blocks_per_strip, last));
    is_loaded = false;
  }
}

template <int D>
void ForcePass<D>::unload_strip(std::size_t first, std::size_t last) {
  const auto clear = [&](auto& array, const auto& nothing) {
    if (!array.empty())
      std::fill(array.begin() + std::ptrdiff_t(first), array.begin() + std::ptrdiff_t(last), nothing);
  };
  clear(blocks_.force, Vector<D>(Vector<D>::Zero()));
  clear(blocks_.torque, Angular<D>(Angular<D>::Zero()));
  clear(dashpot_load_, DashpotLoad());
  if (!blocks_.has_deformable()) return;
  for (std::size_t i = first; i < last; ++i) {
    if (!blocks_.is_deformable(i)) continue;
    blocks_.deformation(i).virial = blocks_.deformation(i).dashpot_virial = Tensor<D>::Zero();
  }
}

template <int D>
void ForcePass<D>::strain(std::size_t i, const Tensor<D>& virial, const Tensor<D>& of_dashpots) {
  if (!blocks_.is_deformable(i)) return;
  blocks_.deformation(i).virial += virial;
  blocks_.deformation(i).dashpot_virial += of_dashpots;
}

template <int D>
double ForcePass<D>::dashpot_power(std::size_t i) const {
  if (dashpot_load_.empty()) return 0;
  const double pushed = dashpot_load_[i].force.dot(blocks_.velocity[i]);
  if (blocks_.is_deformable(i)) {
    const Deformation<D>& deformation = blocks_.deformation(i);
    return -pushed - deformation.dashpot_virial.cwiseProduct(deformation.velocity_gradient()).sum();
  }
  return -pushed - dashpot_load_[i].torque.dot(blocks_.spin[i]);
}

template class ForcePass<2>;
template class ForcePass<3>;

#define HALFSPACE_LOAD(KIND)                                                                          \
  template void ForcePass<2>::load<StiffnessKind::KIND>(std::size_t, const Contact<2>&, Evaluation&); \
  template void ForcePass<3>::load<StiffnessKind::KIND>(std::size_t, const Contact<3>&, Evaluation&);
HALFSPACE_SPRING_KINDS(HALFSPACE_LOAD)
#undef HALFSPACE_LOAD

}  // namespace halfspace
