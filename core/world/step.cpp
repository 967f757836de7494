#include <new>

#include "world/copies.h"
#include "world/world.h"

namespace halfspace {

template <int D>
StepResult World<D>::prepare() {
  if (!state_.is_edited()) return StepResult::ok;
  const StepResult result = stages_.load_changed();
  if (result == StepResult::ok) stages_.end_beginning();
  return result;
}

template <int D>
void World<D>::evaluate_forces_for_host(double elapsed) {
  Blocks<D>& blocks = model_.blocks;
  state_.edit();  // springs and losses change outside the steps
  blocks.mean_spin = blocks.spin;
  stages_.evaluate_forces(elapsed);
  for (std::size_t i = 0; i < blocks.slot_count(); ++i)
    state_.ledger.add_contact_damping_loss(elapsed * state_.forces.dashpot_power(i));
  model_.fix_potential_length();
}

/// Predicts the rest of the step: in one motion, or as much of it as fast blocks may make at once.
template <int D>
StepResult World<D>::predict_rest(Motion& motion) {
  if (state_.ledger.is_unstable()) return StepResult::unstable;
  motion.duration = state_.clock.rest();
  return stages_.run(StageName::actions, StageName::drift, motion);
}

template <int D>
StepResult World<D>::prepare_and_predict(Motion& motion) {
  if (state_.contacts.has_new_blocks()) stages_.bond_new_blocks();
  const StepResult result = prepare();
  return result == StepResult::ok ? predict_rest(motion) : result;
}

/// A changed world finds its contacts and makes its bonds before the memory of the motion is taken: when
/// there is too little, the state before is restored.
template <int D>
StepResult World<D>::predict_changed(Motion& motion) {
  NeighborList<D>& neighbors = state_.contacts.neighbors();
  stages_.renew_neighbors_if_needed();
  neighbors.remember_pairs();
  const std::int64_t builds = neighbors.builds();
  const auto before = copies_of(state_.written_before_motion(), state_.memory());
  try {
    return prepare_and_predict(motion);
  } catch (const std::bad_alloc&) {
    neighbors.recall_pairs();
    state_.written_before_motion() = before;
    if (neighbors.builds() != builds)
      neighbors.invalidate();  // the places of blocks are those of a newer list
    throw;
  }
}

/// Predicts the next motion, unless it cannot be made.
template <int D>
StepResult World<D>::predict_next(Motion& motion) {
  const bool is_changed = state_.is_edited() || state_.contacts.has_new_blocks();
  try {
    const StepResult result = is_changed ? predict_changed(motion) : predict_rest(motion);
    if (result != StepResult::ok) state_.drop_motion();
    return result;
  } catch (const std::bad_alloc&) {
    state_.drop_motion();
    throw;
  }
}

/// Worlds without springs whose contacts are points do not sleep, nor do those with motions or loads in time.
template <int D>
void World<D>::look_for_sleep() {
  const Model<D>& model = model_;
  const Clock& clock = state_.clock;
  if (!(model.settings.sleep_tolerance > 0) || !model.actions.empty()) return;
  if (state_.hard_contacts.is_used() && model.may_have_points()) return;
  if (clock.steps() % steps_between_looks != 0) return;
  const auto touches = [&](auto visit) { state_.for_each_touch(visit); };
  const auto bound_of = [&](std::size_t i) { return state_.integrator.speed_bound_with_impulses_of(i); };
  state_.sleep.look(model, touches, clock.time(), min_sleep_in_steps * clock.time_step(), bound_of);
}

/// One motion, or several where fast blocks divide the step. A step that would take too many, or too many
/// iterations, ends in between, as does one that the host interrupts. It can be continued.
template <int D>
StepResult World<D>::step() {
  Clock& clock = state_.clock;
  state_.drop_shared_motion();
  stages_.begin_step();
  state_.sleep.wake_in_time(clock.time(), clock.time_step());
  for (;;) {
    Motion motion;
    const StepResult result = predict_next(motion);
    if (result != StepResult::ok) return result;
    const bool is_last = motion.duration >= clock.rest();
    stages_.run(StageName::drift, StageName::end, motion);
    if (is_last) break;
    stages_.pass_part(motion.duration);
    if (stages_.is_overworked())
      return state_.names_fast_pair() ? StepResult::too_fast : StepResult::overworked;
    if (interrupt_ && interrupt_->is_requested()) return StepResult::interrupted;
  }
  clock.complete_step();
  look_for_sleep();
  return StepResult::ok;
}

template class World<2>;
template class World<3>;

}  // namespace halfspace
