#include "world/world.h"

#include <algorithm>

namespace halfspace {

template <int D>
World<D>::World(const WorldSettings<D>& settings, Memory* memory)
    : model_(settings, memory),
      contacts_(model_, ledger_, memory),
      forces_(model_, contacts_.neighbors(), memory),
      integrator_(model_, contacts_.neighbors(), forces_, memory),
      stable_step_(model_, contacts_, memory),
      spring_stop_(model_, contacts_),
      fast_motion_(model_, contacts_, integrator_, clock_, stable_step_, spring_stop_, memory) {}

template <int D>
void World<D>::make_bonds() {
  if (model_.materials.laws().any([](const SpringLaw& law) { return law.bonds(); })) {
    detect();
    contacts_.bond_fresh();
    forget_contacts();  // bonded pairs count as such from now on
    edit();
  }
  contacts_.end_fresh();
}

template <int D>
void World<D>::forget_contacts() {
  contacts_.forget();
  forces_.forget();
}

template <int D>
void World<D>::fit_rooms() {
  fast_motion_.fit_room();
  forces_.fit_rooms();
}

/// With room for a contact at every candidate: detection then asks for no memory. When there is none, nothing
/// has changed: the contacts known are still those of the list in use, and there is still room for all of it.
template <int D>
void World<D>::renew_neighbors() {
  NeighborList<D>& neighbors = contacts_.neighbors();
  const bool with_shear =
      model_.materials.laws().any([](const SpringLaw& law) { return law.resists_shear(); });
  neighbors.search_again(model_.blocks, model_.settings.skin, with_shear);
  contacts_.fit_room();
  fit_rooms();
  neighbors.renew(model_.blocks, with_shear);
  forget_contacts();
}

/// For contacts that are to be found.
template <int D>
void World<D>::renew_used_up_neighbors() {
  if (!contacts_.are_found() && contacts_.neighbors().used_up()) renew_neighbors();
}

/// Calls `on_contact(candidate, contact)` for each contact as it is found, described if that is wanted.
template <int D>
template <class OnContact>
void World<D>::find_contacts(OnContact on_contact) {
  forget_contacts();
  Contact<D> contact;
  Array<Candidate<D>>& pairs = contacts_.neighbors().pairs();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const Found found = contacts_.find(k, contact);
    if (found == Found::apart) continue;
    if (found == Found::met) {
      if (made_ > 0 && contacts_.is_described(pairs[k]))
        fast_motion_.describe_entrance(pairs[k], made_, contact);
      spring_stop_.note_meeting(pairs[k]);
    }
    contacts_.keep(k, contact);
    on_contact(k, contact);
  }
  contacts_.end();
}

template <int D>
void World<D>::detect() {
  if (contacts_.are_found()) return;
  renew_used_up_neighbors();
  find_contacts([](std::size_t, const Contact<D>&) {});
}

/// Finds the contacts on the way, unless they are known.
template <int D>
void World<D>::evaluate_forces(double elapsed) {
  renew_used_up_neighbors();
  typename ForcePass<D>::Evaluation evaluation = forces_.begin(elapsed);
  if (contacts_.are_found()) {
    Contact<D> contact;
    for (const std::uint32_t k : contacts_.touching()) {
      const Candidate<D>& pair = contacts_.neighbors().pairs()[k];
      if (!model_.law_of(pair).is_potential()) contacts_.describe(pair, contact);
      forces_.load(k, contact, evaluation);
    }
  } else {
    find_contacts([&](std::size_t k, const Contact<D>& contact) { forces_.load(k, contact, evaluation); });
  }
  forces_.gather(contacts_.touching());
  ledger_.set_contact_strain(evaluation.energy.strain);
  ledger_.add_friction_loss(evaluation.energy.friction_loss);
}

template <int D>
void World<D>::evaluate_forces_for_host(double elapsed) {
  edit();  // springs and losses change outside the steps
  evaluate_forces(elapsed);
  for (std::size_t i = 0; i < model_.blocks.slot_count(); ++i)
    ledger_.add_contact_damping_loss(elapsed * forces_.dashpot_power(i));
  contacts_.neighbors().tidy_plans();
  model_.fix_potential_length();
}

template class World<2>;
template class World<3>;

}  // namespace halfspace
