#include "world/stages/contact_stage.h"

#include <algorithm>

namespace halfspace {

template <int D>
void ContactStage<D>::fit_room() {
  entrances_.fit_room();
  sums_.reserve(chunk_count(state_.contacts.neighbors().room(), pairs_per_chunk));
}

/// Calls `visit(chunk, sums)` for all pairs in the neighbour list, unless no law has springs.
template <int D>
template <class Visit>
void ContactStage<D>::pass_over_pairs(Visit visit) {
  const bool any_spring =
      !state_.hard_contacts.is_used() ||
      state_.model.materials.laws().any([](const ContactLaw& law) { return !law.has_no_spring(); });
  const std::size_t pairs = any_spring ? state_.contacts.neighbors().pairs().size() : 0;
  sum_each_chunk(state_.threads, pairs, pairs_per_chunk, sums_, visit);
}

/// True where pairs need not be asked one by one: all have springs, none sleeps, and all count here.
template <int D>
bool ContactStage<D>::asks_no_pair() const {
  return !state_.hard_contacts.is_used() && !state_.sleep.any() && state_.share.is_whole();
}

/// True for a pair that has no spring, that sleeps, which stays as it was, or that other shares follow.
template <int D>
bool ContactStage<D>::leaves_out(std::size_t k, const Chunk& chunk, PairSums& sums) {
  const Candidate<D>& pair = state_.contacts.neighbors().pairs()[k];
  if (state_.model.law_of(pair).has_no_spring()) return true;
  if (state_.sleep.leaves_out(pair)) {
    state_.contacts.keep_as_it_was(k, chunk.begin, sums);
    return true;
  }
  return !state_.share.follows(pair);
}

/// Finds the contacts of a chunk of pairs. Calls `on_contact(k, contact)` for each that existed before, with
/// the contact computed if is_described().
template <int D>
template <bool asks, class OnContact>
void ContactStage<D>::find_in(const Chunk& chunk, double made, PairSums& sums, OnContact on_contact) {
  Array<Candidate<D>>& pairs = state_.contacts.neighbors().pairs();
  Contact<D> contact;
  const bool any_per_area = state_.model.materials.laws().knows_per_area();
  for (std::size_t k = chunk.begin; k < chunk.end; ++k) {
    if (asks && leaves_out(k, chunk, sums)) continue;
    const double released = sums.released;
    const Found found = state_.contacts.find(k, contact, sums);
    if (asks && !state_.share.counts(pairs[k])) sums.released = released;
    if (found == Found::apart) continue;
    const bool loads_own = !asks || state_.share.loads(pairs[k]);
    // A law per area finds its face by its energy.
    const bool is_pressed = any_per_area && state_.model.law_of(pairs[k]).is_per_area();
    if (found == Found::met && is_pressed && loads_own)
      sums.max_penetration_ratio =
          std::max(sums.max_penetration_ratio, state_.penetration_bound.of_meeting(pairs[k]));
    if (found == Found::met && !is_pressed) {
      if (made > 0 && state_.contacts.is_described(pairs[k]))
        state_.continuous_collision.find_entrance(pairs[k], made, chunk.worker);
      state_.contacts.note_met(k, chunk.begin, sums);
      if (loads_own) state_.contacts.keep(k, chunk.begin, sums);
      continue;
    }
    if (loads_own) state_.contacts.keep(k, chunk.begin, contact, sums);
    if (loads_own || pairs[k].bonded) on_contact(k, contact);
  }
}

template <int D>
template <class OnContact>
void ContactStage<D>::find_in(const Chunk& chunk, double made, PairSums& sums, OnContact on_contact) {
  asks_no_pair() ? find_in<false>(chunk, made, sums, on_contact)
                 : find_in<true>(chunk, made, sums, on_contact);
}

/// Determines the entry faces of pairs that have met.
template <int D>
void ContactStage<D>::find_entrances(double made) {
  entrances_.begin(made);
  for (std::size_t chunk = 0; chunk < sums_.size(); ++chunk) {
    for (const std::uint32_t k : state_.contacts.met_in(chunk, sums_[chunk])) {
      const Candidate<D>& pair = state_.contacts.neighbors().pairs()[k];
      if (state_.contacts.is_described(pair) && state_.share.loads(pair)) entrances_.ask(k);
    }
  }
  for (const auto& [k, face] : entrances_.answers()) {
    Candidate<D>& pair = state_.contacts.neighbors().pairs()[k];
    pair.witness.pair = face;
    state_.share.note_entrance(pair);
  }
}

/// Computes the new contacts, from those that existed before. Calls `on_contact(k, contact, sums)` for each.
template <int D>
template <class OnContact>
void ContactStage<D>::take_in_met(double made, OnContact on_contact) {
  find_entrances(made);
  for (std::size_t chunk = 0; chunk < sums_.size(); ++chunk) {
    PairSums& sums = sums_[chunk];
    for (const std::uint32_t k : state_.contacts.met_in(chunk, sums)) {
      const Candidate<D>& pair = state_.contacts.neighbors().pairs()[k];
      const bool loads_own = state_.share.loads(pair);
      Contact<D> contact;
      if (state_.contacts.is_described(pair)) {
        entrances_.describe(k, contact);
        if (loads_own) state_.contacts.note_overlap(k, contact, sums);
      }
      if (loads_own)
        sums.max_penetration_ratio =
            std::max(sums.max_penetration_ratio, state_.penetration_bound.of_meeting(pair));
      if (loads_own || pair.bonded) on_contact(k, contact, sums);
    }
  }
}

template <int D>
void ContactStage<D>::end_finding() {
  state_.contacts.end(sums_);
  for (const PairSums& sums : sums_) {
    state_.penetration_bound.note(sums.max_penetration_ratio);
    state_.ledger.add_friction_loss(sums.released);
  }
}

template <int D>
void ContactStage<D>::find() {
  if (state_.contacts.are_found()) return;
  state_.forget_contacts();
  pass_over_pairs([&](const Chunk& chunk, PairSums& sums) {
    find_in(chunk, 0, sums, [](std::size_t, const Contact<D>&) {});
  });
  take_in_met(0, [](std::size_t, const Contact<D>&, PairSums&) {});
  end_finding();
}

/// Computes the load of a pair. In a share, its energy may count elsewhere, and it may load copies only.
template <int D>
[[gnu::always_inline]] inline void ContactStage<D>::load_pair(std::size_t k, const Contact<D>& contact,
                                                              Evaluation& evaluation) {
  if (state_.share.is_whole()) return state_.forces.load(k, contact, evaluation);
  const ContactEnergy energy = evaluation.energy;
  const std::int32_t last_block = evaluation.last_block;
  const double peak_overlap = evaluation.peak_overlap;
  state_.forces.load(k, contact, evaluation);
  const Candidate<D>& pair = state_.contacts.neighbors().pairs()[k];
  if (!state_.share.counts(pair)) evaluation.energy = energy;
  if (!state_.share.loads(pair)) {
    evaluation.last_block = last_block;
    evaluation.peak_overlap = peak_overlap;
  }
}

/// Loads the contacts of a chunk of pairs, which are found in the same pass unless they are known.
template <int D>
void ContactStage<D>::load_found(const Chunk& chunk, double made, bool are_found, PairSums& sums,
                                 Evaluation evaluation) {
  evaluation.worker = chunk.worker;
  const auto load = [&](std::size_t k, const Contact<D>& contact) { load_pair(k, contact, evaluation); };
  if (are_found) {
    Contact<D> contact;
    for (const std::uint32_t k : state_.contacts.touching_in(chunk.index)) {
      const Candidate<D>& pair = state_.contacts.neighbors().pairs()[k];
      if (state_.contacts.is_described(pair)) state_.contacts.describe(pair, contact);
      load(k, contact);
    }
  } else {
    find_in(chunk, made, sums, load);
  }
  sums.energy = evaluation.energy;
  sums.peak_overlap = std::max(sums.peak_overlap, evaluation.peak_overlap);
  sums.last_block = std::max(sums.last_block, evaluation.last_block);
}

template <int D>
void ContactStage<D>::load(double elapsed, double made) {
  if (state_.sleep.any() && loaded_sleep_ != state_.sleep.changes()) load_sleeping();
  const bool are_found = state_.contacts.are_found();
  if (!are_found) state_.forget_contacts();
  const Evaluation common = state_.forces.begin(elapsed);
  pass_over_pairs(
      [&](const Chunk& chunk, PairSums& sums) { load_found(chunk, made, are_found, sums, common); });
  if (are_found) return;
  take_in_met(made, [&](std::size_t k, const Contact<D>& contact, PairSums& sums) {
    Evaluation evaluation = common;
    load_pair(k, contact, evaluation);
    sums.energy.add(evaluation.energy);
    sums.last_block = std::max(sums.last_block, evaluation.last_block);
  });
  end_finding();
}

/// The forces of all contacts on each block, and their energies.
template <int D>
void ContactStage<D>::gather() {
  state_.forces.gather(sums_);
  ContactEnergy energy;
  if (state_.sleep.any()) energy.strain = strain_of_sleeping_;
  for (const PairSums& sums : sums_) energy.add(sums.energy);
  state_.ledger.set_contact_strain(energy.strain);
  state_.ledger.add_friction_loss(energy.friction_loss);
}

/// Computes the forces of the contacts that sleep leaves out, once for all steps that skip them.
template <int D>
void ContactStage<D>::load_sleeping() {
  Evaluation evaluation = state_.forces.begin(0);
  const Array<Candidate<D>>& pairs = state_.contacts.neighbors().pairs();
  Contact<D> contact;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!state_.sleep.leaves_out(pairs[k]) || !state_.contacts.was_in_contact(pairs[k])) continue;
    if (state_.contacts.is_described(pairs[k])) state_.contacts.describe(pairs[k], contact);
    state_.forces.load(k, contact, evaluation);
  }
  strain_of_sleeping_ = evaluation.energy.strain;
  loaded_sleep_ = state_.sleep.changes();
}

template class ContactStage<2>;
template class ContactStage<3>;

}  // namespace halfspace
