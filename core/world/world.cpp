#include "world/world.h"

#include <algorithm>
#include <cmath>

#include "world/loads/bolt_pass.h"
#include "world/relaxation/strength.h"

namespace halfspace {

template <int D>
World<D>::World(const WorldSettings<D>& settings, Memory* memory, Threads* threads, Interrupt* interrupt)
    : threads_(threads),
      interrupt_(interrupt),
      model_(settings, memory),
      contacts_(model_, threads, memory),
      forces_(model_, contacts_, threads, memory),
      share_(memory),
      bond_pass_(model_),
      water_pass_(model_, forces_, share_, threads, memory),
      sleep_(memory),
      integrator_(model_, contacts_.neighbors(), forces_, sleep_, share_, threads, memory),
      hard_contacts_(model_, contacts_, integrator_, memory),
      stable_step_(model_, contacts_, memory),
      penetration_bound_(model_, contacts_),
      continuous_collision_(model_, contacts_, integrator_, clock_, stable_step_, penetration_bound_,
                            worker_count(threads), memory),
      entrances_(model_, contacts_, memory),
      sums_(memory) {}

template <int D>
void World<D>::make_bonds() {
  if (model_.materials.laws().any([](const ContactLaw& law) { return law.bonds(); })) {
    detect();
    contacts_.bond_fresh();
    forget_contacts();  // bonded pairs count as contacts from now on
    edit();
  }
  contacts_.end_fresh();
}

template <int D>
void World<D>::forget_contacts() {
  contacts_.forget();
  forces_.forget();
  hard_contacts_.forget_loads();
}

template <int D>
void World<D>::end_reading() {
  model_.actions.renew(model_.blocks);
  model_.viscous_nodes.renew(model_.blocks.meshes());
  integrator_.reserve(model_.blocks.slot_count());
  share_.find_rings(contacts_.neighbors().pairs());
  fit_rooms();
}

template <int D>
void World<D>::fit_rooms() {
  continuous_collision_.fit_room();
  forces_.fit_rooms();
  hard_contacts_.fit_room();
  if (!model_.water.empty()) water_pass_.fit_room();
  entrances_.fit_room();
  sums_.reserve(chunk_count(contacts_.neighbors().room(), pairs_per_chunk));
}

/// Reserves memory for a contact of every pair, so that detection allocates nothing. If memory runs out,
/// nothing has changed: contacts, list and memory in use remain valid. `renewals`: how often the coming
/// motion has had the list renewed. Impulses move blocks farther than the motion without them: skins have a
/// reserve, and grow until they cover both.
template <int D>
void World<D>::renew_neighbors(int renewals) {
  NeighborList<D>& neighbors = contacts_.neighbors();
  Bonds<D>& bonds = model_.blocks.bonds();
  if (!bonds.rings().is_current()) bonds.rings().find(model_.blocks);
  const bool with_shear =
      model_.materials.laws().any([](const ContactLaw& law) { return law.resists_shear(); });
  const SkinRule skins{model_.settings.skin, hard_contacts_.is_used() ? 4.0 : 1.0, renewals == 0,
                       share_.common().typical_radius};
  neighbors.search_again(model_.blocks, skins, with_shear);
  contacts_.fit_room();
  fit_rooms();
  neighbors.renew(model_.blocks, with_shear);
  share_.find_rings(neighbors.pairs());
  if (!bonds.empty()) bond_pass_.hand_over(contacts_);
  forget_contacts();
  are_left_out_loaded_ = false;
}

/// Detection requires a valid neighbour list.
template <int D>
void World<D>::renew_neighbors_if_needed() {
  if (!contacts_.are_found() && contacts_.neighbors().needs_rebuild()) renew_neighbors();
}

/// Finds the contacts of a chunk of pairs. Calls `on_contact(k, contact)` for each that existed before, with
/// the contact computed if is_described(). In a share, pairs of copies are found, but do not count.
template <int D>
template <class OnContact>
void World<D>::find_in(const Chunk& chunk, PairSums& sums, OnContact on_contact) {
  Array<Candidate<D>>& pairs = contacts_.neighbors().pairs();
  Contact<D> contact;
  const bool some_have_no_spring = hard_contacts_.is_used();
  for (std::size_t k = chunk.begin; k < chunk.end; ++k) {
    if (some_have_no_spring && model_.law_of(pairs[k]).has_no_spring()) continue;
    if (sleep_.leaves_out(pairs[k])) {
      contacts_.keep_as_it_was(k, chunk.begin, sums);
      continue;
    }
    if (!share_.follows(pairs[k])) continue;
    const double released = sums.released;
    const Found found = contacts_.find(k, contact, sums);
    if (!share_.counts(pairs[k])) sums.released = released;
    if (found == Found::apart) continue;
    const bool loads_own = share_.loads(pairs[k]);
    const bool is_pressed = model_.law_of(pairs[k]).is_per_area();  // finds its face by its energy
    if (found == Found::met && is_pressed && loads_own)
      sums.max_penetration_ratio =
          std::max(sums.max_penetration_ratio, penetration_bound_.of_meeting(pairs[k]));
    if (found == Found::met && !is_pressed) {
      if (made_ > 0 && contacts_.is_described(pairs[k]))
        continuous_collision_.find_entrance(pairs[k], made_, chunk.worker);
      contacts_.note_met(k, chunk.begin, sums);
      if (loads_own) contacts_.keep(k, chunk.begin, sums);
      continue;
    }
    if (loads_own) contacts_.keep(k, chunk.begin, contact, sums);
    if (loads_own || pairs[k].bonded) on_contact(k, contact);
  }
}

/// Determines the entry faces of pairs that have met.
template <int D>
void World<D>::find_entrances() {
  entrances_.begin(made_);
  for (std::size_t chunk = 0; chunk < sums_.size(); ++chunk) {
    for (const std::uint32_t k : contacts_.met_in(chunk, sums_[chunk])) {
      const Candidate<D>& pair = contacts_.neighbors().pairs()[k];
      if (contacts_.is_described(pair) && share_.loads(pair)) entrances_.ask(k);
    }
  }
  for (const auto& [k, face] : entrances_.answers()) {
    Candidate<D>& pair = contacts_.neighbors().pairs()[k];
    pair.witness.pair = face;
    share_.note_entrance(pair);
  }
}

/// Computes the new contacts, from those that existed before. Calls `on_contact(k, contact, sums)` for each.
template <int D>
template <class OnContact>
void World<D>::take_in_met(OnContact on_contact) {
  find_entrances();
  for (std::size_t chunk = 0; chunk < sums_.size(); ++chunk) {
    PairSums& sums = sums_[chunk];
    for (const std::uint32_t k : contacts_.met_in(chunk, sums)) {
      const Candidate<D>& pair = contacts_.neighbors().pairs()[k];
      const bool loads_own = share_.loads(pair);
      Contact<D> contact;
      if (contacts_.is_described(pair)) {
        entrances_.describe(k, contact);
        if (loads_own) contacts_.note_overlap(k, contact, sums);
      }
      if (loads_own)
        sums.max_penetration_ratio =
            std::max(sums.max_penetration_ratio, penetration_bound_.of_meeting(pair));
      if (loads_own || pair.bonded) on_contact(k, contact, sums);
    }
  }
}

/// Calls `visit(chunk, sums)` for all pairs in the neighbour list.
template <int D>
template <class Visit>
void World<D>::pass_over_pairs(Visit visit) {
  const std::size_t pairs = contacts_.neighbors().pairs().size();
  sum_each_chunk(threads_, pairs, pairs_per_chunk, sums_, visit);
}

template <int D>
void World<D>::end_finding() {
  contacts_.end(sums_);
  for (const PairSums& sums : sums_) {
    penetration_bound_.note(sums.max_penetration_ratio);
    ledger_.add_friction_loss(sums.released);
  }
}

template <int D>
void World<D>::detect() {
  if (contacts_.are_found()) return;
  renew_neighbors_if_needed();
  forget_contacts();
  pass_over_pairs([&](const Chunk& chunk, PairSums& sums) {
    find_in(chunk, sums, [](std::size_t, const Contact<D>&) {});
  });
  take_in_met([](std::size_t, const Contact<D>&, PairSums&) {});
  end_finding();
}

/// Computes the load of a pair. In a share, its energy may count elsewhere, and it may load copies only.
template <int D>
[[gnu::always_inline]] inline bool World<D>::load_pair(std::size_t k, const Contact<D>& contact,
                                                       typename ForcePass<D>::Evaluation& evaluation) {
  const ContactEnergy energy = evaluation.energy;
  const std::int32_t last_block = evaluation.last_block;
  const double peak_overlap = evaluation.peak_overlap;
  const bool is_loaded = forces_.load(k, contact, evaluation);
  if (share_.is_whole()) return is_loaded;
  const Candidate<D>& pair = contacts_.neighbors().pairs()[k];
  if (!share_.counts(pair)) evaluation.energy = energy;
  if (!share_.loads(pair)) {
    evaluation.last_block = last_block;
    evaluation.peak_overlap = peak_overlap;
  }
  return is_loaded;
}

/// Finds the contacts in the same pass, unless they are known.
template <int D>
void World<D>::evaluate_forces(double elapsed) {
  renew_neighbors_if_needed();
  if (sleep_.any() && !are_left_out_loaded_) load_left_out();
  const bool are_found = contacts_.are_found();
  if (!are_found) forget_contacts();
  const typename ForcePass<D>::Evaluation common = forces_.begin(elapsed);
  pass_over_pairs([&](const Chunk& chunk, PairSums& sums) {
    typename ForcePass<D>::Evaluation evaluation = common;
    evaluation.worker = chunk.worker;
    const auto load = [&](std::size_t k, const Contact<D>& contact) {
      if (!load_pair(k, contact, evaluation)) contacts_.note_without_plan(k, chunk.begin, sums);
    };
    if (are_found) {
      Contact<D> contact;
      for (const std::uint32_t k : contacts_.touching_in(chunk.index)) {
        const Candidate<D>& pair = contacts_.neighbors().pairs()[k];
        if (contacts_.is_described(pair)) contacts_.describe(pair, contact);
        load(k, contact);
      }
    } else {
      find_in(chunk, sums, load);
    }
    sums.energy = evaluation.energy;
    sums.peak_overlap = std::max(sums.peak_overlap, evaluation.peak_overlap);
    sums.last_block = std::max(sums.last_block, evaluation.last_block);
  });
  // In order, as new division plans share their memory.
  const auto load_in_order = [&](std::size_t k, const Contact<D>& contact, PairSums& sums) {
    typename ForcePass<D>::Evaluation evaluation = common;
    evaluation.makes_plans = true;
    load_pair(k, contact, evaluation);
    sums.energy.add(evaluation.energy);
    sums.last_block = std::max(sums.last_block, evaluation.last_block);
  };
  for (std::size_t chunk = 0; chunk < sums_.size(); ++chunk) {
    for (const std::uint32_t k : contacts_.without_plan_in(chunk, sums_[chunk]))
      load_in_order(k, {}, sums_[chunk]);
  }
  if (!are_found) {
    take_in_met(load_in_order);
    end_finding();
  }
  lap(Pass::pairs);
  forces_.gather(sums_);
  ContactEnergy energy;
  if (sleep_.any()) energy.strain = left_out_strain_;
  for (const PairSums& sums : sums_) energy.add(sums.energy);
  ledger_.set_contact_strain(energy.strain);
  ledger_.add_friction_loss(energy.friction_loss);
  // A touched island has slept in this motion: the forces at its end move it. Impulses do so in move().
  if (!hard_contacts_.is_used()) wake_touched(clock_.time() + elapsed);
  lap(Pass::gather);
  load_by_water_and_bolts();
  if (!model_.blocks.bonds().empty()) {
    load_by_bonds(elapsed);
    lap(Pass::bonds);
  }
  forces_.load_compounds();
}

/// Computes the forces of the contacts that sleep leaves out, once for all steps that skip them.
template <int D>
void World<D>::load_left_out() {
  typename ForcePass<D>::Evaluation evaluation = forces_.begin(0);
  const Array<Candidate<D>>& pairs = contacts_.neighbors().pairs();
  Contact<D> contact;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!sleep_.leaves_out(pairs[k]) || !contacts_.was_in_contact(pairs[k])) continue;
    if (contacts_.is_described(pairs[k])) contacts_.describe(pairs[k], contact);
    forces_.load(k, contact, evaluation);
  }
  left_out_strain_ = evaluation.energy.strain;
  are_left_out_loaded_ = true;
}

/// Worlds without springs whose contacts are points do not sleep, nor do those with motions or loads in time.
template <int D>
void World<D>::look_for_sleep() {
  if (!(model_.settings.sleep_tolerance > 0) || (hard_contacts_.is_used() && model_.may_have_points()))
    return;
  if (!model_.actions.empty()) return;
  if (clock_.steps() % steps_between_looks != 0) return;
  const auto touches = [&](auto visit) { for_each_touch(visit); };
  const auto bound_of = [&](std::size_t i) { return integrator_.speed_bound_with_impulses_of(i); };
  if (sleep_.look(model_, touches, clock_.time(), least_sleep_in_steps * clock_.time_step(), bound_of))
    are_left_out_loaded_ = false;
}

/// Call after the contact forces. Detection includes separated bonds from the next motion on.
template <int D>
void World<D>::load_by_bonds(double elapsed) {
  BondEnergy energy;
  if (bond_pass_.load(clock_.steps(), clock_.time() + elapsed, energy)) contacts_.neighbors().invalidate();
  bond_strain_energy_ = energy.strain;
  ledger_.set_contact_strain(ledger_.entries().strain + energy.strain);
  ledger_.add_fracture_loss(energy.fracture_loss);
  ledger_.add_friction_loss(energy.friction_loss);
}

/// Call after the contact forces.
template <int D>
void World<D>::load_by_water_and_bolts() {
  ledger_.set_water(model_.water.empty() ? 0 : water_pass_.load());
  if (!model_.water.empty()) lap(Pass::water);
  bolt_strain_energy_ = 0;
  if (model_.bolts.empty()) return;
  const BoltEnergy energy = load_by_bolts(model_, forces_);
  bolt_strain_energy_ = energy.strain;
  ledger_.set_contact_strain(ledger_.entries().strain + energy.strain);
  ledger_.add_bolt_loss(energy.loss);
  lap(Pass::bolts);
}

template <int D>
void World<D>::evaluate_forces_for_host(double elapsed) {
  edit();  // springs and losses change outside the steps
  model_.blocks.mean_spin = model_.blocks.spin;
  evaluate_forces(elapsed);
  for (std::size_t i = 0; i < model_.blocks.slot_count(); ++i)
    ledger_.add_contact_damping_loss(elapsed * forces_.dashpot_power(i));
  contacts_.neighbors().tidy_plans();
  model_.fix_potential_length();
}

template <int D>
double World<D>::largest_overlap() const {
  return max_of_each(threads_, contact_count(), pairs_per_chunk, hard_contacts_.rigid().largest_overlap(),
                     [&](std::size_t c) { return -contact(c).gap; });
}

template <int D>
double World<D>::largest_speed() const {
  const double squared =
      max_of_each(threads_, blocks().slot_count(), blocks_per_chunk, 0, [&](std::size_t i) {
        return blocks().moves_freely(i) && !blocks().is_part(i) ? blocks().velocity[i].squaredNorm() : 0;
      });
  return std::sqrt(squared);
}

template <int D>
bool World<D>::is_consistent() const {
  return model_.is_consistent() && contacts_.is_consistent() && integrator_.is_consistent(edited_) &&
         (edited_ || contacts_.neighbors().list_length() == model_.blocks.slot_count()) &&
         clock_.is_consistent() && hard_contacts_.is_consistent() &&
         sleep_.is_consistent(model_.blocks.slot_count(), !edited_ && model_.settings.sleep_tolerance > 0) &&
         penetration_bound_.is_consistent() && is_nonnegative(peak_speed_) &&
         is_strength_factor(strength_factor_) &&
         share_.is_consistent(model_.blocks.slot_count(),
                              [&](std::size_t i) { return !model_.blocks.moves_freely(i); });
}

template class World<2>;
template class World<3>;

}  // namespace halfspace
