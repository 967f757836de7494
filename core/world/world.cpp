#include "world/world.h"

#include <algorithm>
#include <cmath>

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
      sleep_(memory),
      integrator_(model_, contacts_.neighbors(), forces_, sleep_, share_, threads, memory),
      hard_contacts_(model_, contacts_, integrator_, memory),
      stable_step_(model_, contacts_, memory),
      penetration_bound_(model_, contacts_),
      continuous_collision_(model_, contacts_, integrator_, clock_, stable_step_, penetration_bound_,
                            worker_count(threads), memory),
      contact_stage_(model_, contacts_, forces_, hard_contacts_, penetration_bound_, continuous_collision_,
                     sleep_, share_, ledger_, threads, memory),
      load_stage_(model_, contacts_, forces_, share_, ledger_, threads, memory) {}

template <int D>
void World<D>::make_bonds() {
  if (model_.materials.laws().any([](const ContactLaw& law) { return law.bonds(); })) {
    detect();
    contacts_.bond_fresh();
    contact_stage_.forget();  // bonded pairs count as contacts from now on
    edit();
  }
  contacts_.end_fresh();
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
  load_stage_.fit_room();
  contact_stage_.fit_room();
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
  load_stage_.hand_over_bonds();
  contact_stage_.forget();
  contact_stage_.forget_sleeping();
}

/// Detection requires a valid neighbour list.
template <int D>
void World<D>::renew_neighbors_if_needed() {
  if (!contacts_.are_found() && contacts_.neighbors().needs_rebuild()) renew_neighbors();
}

template <int D>
void World<D>::detect() {
  renew_neighbors_if_needed();
  contact_stage_.find();
}

/// `made`: duration of the motion that has led here, s, or 0.
template <int D>
void World<D>::evaluate_forces(double elapsed, double made) {
  renew_neighbors_if_needed();
  contact_stage_.load(elapsed, made);
  lap(Pass::pairs);
  contact_stage_.gather();
  // A touched island has slept in this motion: the forces at its end move it. Impulses do so in move().
  if (!hard_contacts_.is_used()) wake_touched(clock_.time() + elapsed);
  lap(Pass::gather);
  load_stage_.load(clock_.steps(), clock_.time() + elapsed, stopwatch_);
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
    contact_stage_.forget_sleeping();
}

template <int D>
void World<D>::evaluate_forces_for_host(double elapsed) {
  edit();  // springs and losses change outside the steps
  model_.blocks.mean_spin = model_.blocks.spin;
  evaluate_forces(elapsed, 0);
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
