#include "world/stages/contact_stage.h"

#include <algorithm>

namespace halfspace {

template <int D>
void ContactStage<D>::fit_room() {
  pairs_.reserve(state_.contacts.neighbors().room());
  sorted_for_.reset();
  entrances_.fit_room();
  sums_.reserve(chunk_count(state_.contacts.neighbors().room(), pairs_per_chunk));
}

/// Sorts the pairs by their laws, if the list or sleep has changed.
template <int D>
void ContactStage<D>::sort_pairs() {
  if (sorted_for_ == state_.sleep.changes()) return;
  pairs_.sort(state_.model, state_.sleep, state_.share, state_.contacts.neighbors().pairs());
  sorted_for_ = state_.sleep.changes();
  are_sleepers_loaded_ = false;
}

/// Calls `visit(chunk, sums)` for all chunks of pairs, unless no law has springs.
template <int D>
template <class Visit>
void ContactStage<D>::pass_over_pairs(Visit visit) {
  const std::size_t pairs = pairs_.empty() ? 0 : state_.contacts.neighbors().pairs().size();
  sum_each_chunk(state_.threads, pairs, pairs_per_chunk, sums_, visit);
}

/// Finds the contacts of a chunk of pairs, law by law. Calls `on_contact(kind, k, contact)` for each that
/// existed before, with the contact computed if is_described().
template <int D>
template <class OnContact>
void ContactStage<D>::find_in(const Chunk& chunk, double made, PairSums& sums, OnContact on_contact) {
  ContactList<D>& contacts = state_.contacts;
  const bool is_whole = state_.share.is_whole();
  for_each_spring_kind([&](auto kind) {
    Contact<D> contact;
    for (const std::uint32_t k : pairs_.under(kind, chunk.index)) {
      Candidate<D>& pair = contacts.neighbors().pairs()[k];
      const double released = sums.released;
      const Found found = contacts.template find<kind>(k, contact, sums);
      if (!is_whole && !state_.share.counts(pair)) sums.released = released;
      if (found == Found::apart) continue;
      const bool loads_own = is_whole || state_.share.loads(pair);
      if (loads_own) contacts.keep(k, chunk.begin, sums);
      // A law per area finds its face by its energy, and needs no entry face.
      if (found == Found::met && kind != StiffnessKind::per_area) {
        if (made > 0 && contacts.template is_described<kind>(pair))
          state_.continuous_collision.find_entrance(pair, made, chunk.worker);
        contacts.note_met(k, chunk.begin, sums);
        continue;
      }
      if (loads_own) note_found<kind>(pair, contact, found, sums);
      if (loads_own || pair.bonded) on_contact(kind, k, contact);
    }
  });
  for (const std::uint32_t k : pairs_.asleep(chunk.index)) contacts.keep_as_it_was(k, chunk.begin, sums);
  if (pairs_.is_mixed(chunk.index)) contacts.put_in_order(chunk.begin, sums);
}

/// Notes how deep a contact with its final description is.
template <int D>
template <StiffnessKind kind>
void ContactStage<D>::note_found(const Candidate<D>& pair, const Contact<D>& contact, Found found,
                                 PairSums& sums) const {
  state_.contacts.template note_overlap<kind>(contact, sums);
  if (found == Found::met)
    sums.max_penetration_ratio =
        std::max(sums.max_penetration_ratio, state_.penetration_bound.of_meeting(pair));
}

/// Determines the entry faces of pairs that have met.
template <int D>
void ContactStage<D>::find_entrances(double made) {
  entrances_.begin(made);
  for (std::size_t chunk = 0; chunk < sums_.size(); ++chunk) {
    for (const std::uint32_t k : state_.contacts.met_in(chunk, sums_[chunk])) {
      const Candidate<D>& pair = state_.contacts.neighbors().pairs()[k];
      for_kind_of(pair, [&](auto kind) {
        if (state_.contacts.template is_described<kind>(pair) && state_.share.loads(pair)) entrances_.ask(k);
      });
    }
  }
  for (const auto& [k, face] : entrances_.answers()) {
    Candidate<D>& pair = state_.contacts.neighbors().pairs()[k];
    pair.witness.pair = face;
    state_.share.note_entrance(pair);
  }
}

/// Computes the new contacts, from those that existed before. Calls `on_contact(kind, k, contact, sums)` for
/// each.
template <int D>
template <class OnContact>
void ContactStage<D>::take_in_met(double made, OnContact on_contact) {
  find_entrances(made);
  for (std::size_t chunk = 0; chunk < sums_.size(); ++chunk) {
    PairSums& sums = sums_[chunk];
    for (const std::uint32_t k : state_.contacts.met_in(chunk, sums)) {
      const Candidate<D>& pair = state_.contacts.neighbors().pairs()[k];
      const bool loads_own = state_.share.loads(pair);
      for_kind_of(pair, [&](auto kind) {
        Contact<D> contact;
        if (state_.contacts.template is_described<kind>(pair)) entrances_.describe(k, contact);
        if (loads_own) note_found<kind>(pair, contact, Found::met, sums);
        if (loads_own || pair.bonded) on_contact(kind, k, contact, sums);
      });
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
  sort_pairs();
  pass_over_pairs([&](const Chunk& chunk, PairSums& sums) {
    find_in(chunk, 0, sums, [](auto, std::size_t, const Contact<D>&) {});
  });
  take_in_met(0, [](auto, std::size_t, const Contact<D>&, PairSums&) {});
  end_finding();
}

/// Computes the load of a pair. In a share, its energy may count elsewhere, and it may load copies only.
template <int D>
template <StiffnessKind kind>
[[gnu::always_inline]] inline void ContactStage<D>::load_pair(std::size_t k, const Contact<D>& contact,
                                                              Evaluation& evaluation) {
  ForcePass<D>& forces = state_.forces;
  if (state_.share.is_whole()) return forces.template load<kind>(k, contact, evaluation);
  const ContactEnergy energy = evaluation.energy;
  const std::int32_t last_block = evaluation.last_block;
  const double peak_overlap = evaluation.peak_overlap;
  forces.template load<kind>(k, contact, evaluation);
  const Candidate<D>& pair = state_.contacts.neighbors().pairs()[k];
  if (!state_.share.counts(pair)) evaluation.energy = energy;
  if (!state_.share.loads(pair)) {
    evaluation.last_block = last_block;
    evaluation.peak_overlap = peak_overlap;
  }
}

/// Computes the load of a pair known to be in contact.
template <int D>
void ContactStage<D>::load_known(std::size_t k, Evaluation& evaluation) {
  const Candidate<D>& pair = state_.contacts.neighbors().pairs()[k];
  for_kind_of(pair, [&](auto kind) {
    Contact<D> contact;
    if (state_.contacts.template is_described<kind>(pair)) state_.contacts.describe(pair, contact);
    load_pair<kind>(k, contact, evaluation);
  });
}

/// Contacts are found in the same pass unless they are known.
template <int D>
void ContactStage<D>::load(double elapsed, double made) {
  sort_pairs();
  if (!are_sleepers_loaded_) load_sleepers();
  const bool are_found = state_.contacts.are_found();
  if (!are_found) state_.forget_contacts();
  const Evaluation common = state_.forces.begin(elapsed);
  pass_over_pairs([&](const Chunk& chunk, PairSums& sums) {
    Evaluation evaluation = common;
    evaluation.worker = chunk.worker;
    if (are_found) {
      for (const std::uint32_t k : state_.contacts.touching_in(chunk.index)) load_known(k, evaluation);
    } else {
      find_in(chunk, made, sums, [&](auto kind, std::size_t k, const Contact<D>& contact) {
        load_pair<kind>(k, contact, evaluation);
      });
    }
    sums.energy = evaluation.energy;
    sums.peak_overlap = std::max(sums.peak_overlap, evaluation.peak_overlap);
    sums.last_block = std::max(sums.last_block, evaluation.last_block);
  });
  if (are_found) return;
  take_in_met(made, [&](auto kind, std::size_t k, const Contact<D>& contact, PairSums& sums) {
    Evaluation evaluation = common;
    load_pair<kind>(k, contact, evaluation);
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
  energy.strain = strain_of_sleepers_;
  for (const PairSums& sums : sums_) energy.add(sums.energy);
  state_.ledger.set_contact_strain(energy.strain);
  state_.ledger.add_friction_loss(energy.friction_loss);
}

/// Computes the forces of the contacts that sleep leaves out, once for all steps that skip them.
template <int D>
void ContactStage<D>::load_sleepers() {
  Evaluation evaluation = state_.forces.begin(0);
  const std::size_t chunks = chunk_count(state_.contacts.neighbors().pairs().size(), pairs_per_chunk);
  for (std::size_t chunk = 0; chunk < chunks; ++chunk)
    for (const std::uint32_t k : pairs_.asleep(chunk)) load_known(k, evaluation);
  strain_of_sleepers_ = evaluation.energy.strain;
  are_sleepers_loaded_ = true;
}

template class ContactStage<2>;
template class ContactStage<3>;

}  // namespace halfspace
