#include "world/stages/state.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfspace {

template <int D>
State<D>::State(Model<D>& of, Threads* workers)
    : model(of),
      threads(workers),
      contacts(model, threads, memory()),
      forces(model, contacts, threads, memory()),
      share(memory()),
      sleep(memory()),
      integrator(model, contacts.neighbors(), forces, sleep, share, threads, memory()),
      hard_contacts(model, contacts, integrator, memory()),
      stable_step(model, contacts, memory()),
      penetration_bound(model, contacts),
      continuous_collision(model, contacts, integrator, clock, stable_step, penetration_bound,
                           worker_count(threads), memory()) {}

template <int D>
void State<D>::edit() {
  drop_shared_motion();
  if (!edited) ledger.note_edit();
  edited = true;
  hard_contacts.forget_rest();
  sleep.wake_all(clock.time());
}

template <int D>
void State<D>::change_contacts() {
  forget_contacts();
  edit();
}

template <int D>
void State<D>::change_pairs() {
  contacts.neighbors().invalidate();
  change_contacts();
}

template <int D>
void State<D>::drop_motion() {
  model.actions.drop_motion(model.blocks);
  hard_contacts.drop_motion();
  contacts.neighbors().forget_announcements();
}

template <int D>
void State<D>::drop_shared_motion() {
  if (share.stage() != ShareStage::planned) return;
  drop_motion();
  share.enter(ShareStage::ready);
}

template <int D>
void State<D>::forget_contacts() {
  contacts.forget();
  forces.forget();
  hard_contacts.forget_loads();
}

template <int D>
void State<D>::forget_block(std::int32_t slot) {
  share.forget_keys();
  model.bolts.forget(slot);
  contacts.neighbors().forget(slot);
  hard_contacts.forget(slot);
  integrator.forget_reaction();
  change_contacts();
  sleep.forget(std::size_t(slot));
}

template <int D>
void State<D>::note_added(std::int32_t slot) {
  contacts.add_fresh(slot, model.blocks.slot_count());
  contacts.neighbors().invalidate();
  share.forget_keys();
}

/// An infinite speed counts as the largest finite one.
template <int D>
void State<D>::note_speeds(const EnergySample& sample) {
  peak_speed =
      std::max(peak_speed, std::min(std::sqrt(sample.squared_speed), std::numeric_limits<double>::max()));
  continuous_collision.note_speeds(sample);
}

template <int D>
double State<D>::largest_overlap() const {
  return max_of_each(threads, contacts.count(), pairs_per_chunk, hard_contacts.rigid().largest_overlap(),
                     [&](std::size_t c) { return -contacts.contact(c).gap; });
}

template <int D>
double State<D>::largest_speed() const {
  const Blocks<D>& blocks = model.blocks;
  const double squared = max_of_each(threads, blocks.slot_count(), blocks_per_chunk, 0, [&](std::size_t i) {
    return blocks.moves_freely(i) && !blocks.is_part(i) ? blocks.velocity[i].squaredNorm() : 0;
  });
  return std::sqrt(squared);
}

template <int D>
bool State<D>::is_consistent() const {
  const std::size_t slots = model.blocks.slot_count();
  return model.is_consistent() && contacts.is_consistent() && integrator.is_consistent(edited) &&
         (edited || contacts.neighbors().list_length() == slots) && clock.is_consistent() &&
         hard_contacts.is_consistent() &&
         sleep.is_consistent(slots, !edited && model.settings.sleep_tolerance > 0) &&
         penetration_bound.is_consistent() && is_nonnegative(peak_speed) &&
         is_strength_factor(strength_factor) &&
         share.is_consistent(slots, [&](std::size_t i) { return !model.blocks.moves_freely(i); });
}

template struct State<2>;
template struct State<3>;

}  // namespace halfspace
