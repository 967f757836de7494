#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "world/copies.h"
#include "world/world.h"

// A step of velocity Verlet is one motion, or several where fast blocks divide it. The stages of a motion:
//
//   predict  predict_motion(): half a kick and a drift are computed, and the impulses of contacts without
//            springs; the neighbour list is renewed if the motion would use it up
//   divide   divide(): a motion in which a block turns too far or a fast pair overlaps deeply is shortened
//   move     move(): kick and drift
//   load     evaluate_forces(): contacts, their forces and the sums of each block (stages/contact_stage.h)
//   kick     the second half of the kick, then the impulses that stop approach
//   book     the ledger takes the energies after the motion

namespace halfspace {
namespace {

/// A part this large is the whole motion: times of impact are accurate to rounding.
constexpr double whole_part = 1 - 1e-12;

/// No motion is a smaller part of a step, and none that ends at an impact is smaller than this.
constexpr double min_part = 0x1p-24, min_located_part = 0x1p-16;

/// Rebounds that follow each other ever faster would divide a step without end: after so many motions impacts
/// are no longer located in it.
constexpr int max_located_motions = 64;

/// An impact that passes from block to block lengthens motions each time.
constexpr int max_renewals = 16;

constexpr double largest_double = std::numeric_limits<double>::max();

}  // namespace

/// Predicts the coming motion and takes all its memory, so that a motion once begun completes. False when it
/// diverges.
template <int D>
bool World<D>::predict_motion(double duration) {
  if (!model_.actions.empty()) predict_actions(duration);
  for (int renewals = 0; renewals < max_renewals; ++renewals) {
    hard_contacts_.begin(duration);
    if (!integrator_.predict(duration)) return false;
    lap(Pass::motion);
    if (contacts_.neighbors().needs_rebuild()) renew_neighbors(renewals);
    lap(Pass::search);
    if (wake_met(duration)) {
      hard_contacts_.begin(duration);
      if (!integrator_.predict(duration)) return false;
    }
    const bool is_predicted = hard_contacts_.predict(clock_.time(), duration);
    lap(Pass::hard_contacts);
    if (!is_predicted) return false;
    if (!contacts_.neighbors().needs_rebuild()) return true;
    renew_neighbors(renewals + 1);
  }
  return false;
}

/// Sets the loads and velocities that tables give for the coming motion.
template <int D>
void World<D>::predict_actions(double duration) {
  Actions<D>& actions = model_.actions;
  for (auto& target : actions.targets()) {
    if (!target.is_servo) continue;
    const auto contacts = stable_step_.sum_over_contacts_of(target.slot);
    target.servo.adapt(contacts.stiffness, contacts.viscosity, duration, clock_.time_step());
  }
  actions.predict({clock_.time(), duration}, model_.blocks);
  integrator_.take_actions(duration);
}

/// Wakes islands that blocks without springs meet in the coming motion: impulses act on both. True if there
/// are any.
template <int D>
bool World<D>::wake_met(double duration) {
  if (!sleep_.any()) return false;
  const auto meetings = [&](auto visit) { hard_contacts_.for_each_meeting(duration, visit); };
  const bool has_woken = sleep_.wake_touched(meetings, clock_.time());
  wake(has_woken);
  return has_woken;
}

/// The result of a step whose motion cannot be predicted.
template <int D>
StepResult World<D>::diverged() const {
  return inverted_cell().body >= 0 ? StepResult::inverted : StepResult::unstable;
}

/// Shortens the predicted motion until it can be made at once: no block turns by more than an angle whose arc
/// is as long as its radius, and no fast pair overlaps deeply.
template <int D>
StepResult World<D>::divide() {
  for (;;) {
    double part = 1;
    if (integrator_.max_rotation() > max_turn) {
      part = 0.9 * max_turn / integrator_.max_rotation();
    } else if (continuous_collision_.any()) {
      part = continuous_collision_.safe_fraction();
      if (part < 1 && model_.settings.fast_blocks == FastBlocks::refuse) return StepResult::too_fast;
    }
    // Impacts that follow each other without end are not told apart.
    const double before_impact = hard_contacts_.fraction_before_impact();
    if (motions_ < max_located_motions &&
        before_impact * integrator_.duration() >= min_located_part * clock_.time_step())
      part = std::min(part, before_impact);
    if (part >= whole_part) return StepResult::ok;
    if (!(part * integrator_.duration() >= min_part * clock_.time_step())) return StepResult::unstable;
    if (is_overworked()) return StepResult::overworked;
    if (!predict_motion(part * integrator_.duration())) return diverged();
  }
}

template <int D>
bool World<D>::choose_time_step() {
  if (model_.settings.time_step != 0) return clock_.choose(model_.settings.time_step);
  detect();  // the present contacts count
  const double stable = model_.settings.safety * stable_step_.bound();
  // A step that is divided where blocks are fast does not depend on speeds.
  return clock_.choose(model_.settings.fast_blocks == FastBlocks::refuse
                           ? std::min(stable, continuous_collision_.safe_time_step())
                           : stable);
}

template <int D>
void World<D>::note_speeds(const EnergySample& sample) {
  // An infinite speed counts as the largest finite one.
  peak_speed_ = std::max(peak_speed_, std::min(std::sqrt(sample.squared_speed), largest_double));
  continuous_collision_.note_speeds(sample);
}

template <int D>
StepResult World<D>::prepare() {
  if (!edited_) return StepResult::ok;
  const StepResult result = load_changed();
  if (result == StepResult::ok) end_beginning();
  return result;
}

/// Contacts and forces of a changed world.
template <int D>
StepResult World<D>::load_changed() {
  // Memory of blocks is taken first, that of pairs by detection: contacts are found only when all of it is
  // there.
  const std::size_t slots = model_.blocks.slot_count();
  model_.actions.renew(model_.blocks);
  stable_step_.reserve(slots);
  integrator_.reserve(slots);
  if (model_.settings.sleep_tolerance > 0) sleep_.reserve(slots);
  if (!choose_time_step()) return StepResult::no_time_step;
  integrator_.resize(slots);
  if (!model_.viscous_nodes.empty()) model_.viscous_nodes.renew(model_.blocks.meshes());
  if (model_.settings.sleep_tolerance > 0) sleep_.resize(slots);
  evaluate_forces(0, 0);
  return StepResult::ok;
}

/// Accelerations and ledger of a changed world, from its forces.
template <int D>
void World<D>::end_beginning() {
  double noise = 0;
  const EnergySample sample = integrator_.begin(clock_.time_step(), noise);
  note_speeds(sample);
  ledger_.begin(sample, noise);
  edited_ = false;
}

/// The predicted motion, from where forces are known to where they are known again.
template <int D>
void World<D>::move() {
  move_and_load();
  end_motion();
}

template <int D>
void World<D>::move_and_load() {
  const double duration = integrator_.duration();
  model_.fix_potential_length();
  if (!model_.actions.empty()) ledger_.add_outer_power(integrator_.power_of_jumps());
  model_.actions.accept_motion();
  hard_contacts_.apply_position_impulses(ledger_);
  integrator_.kick_and_drift();
  contact_stage_.forget();
  lap(Pass::motion);

  evaluate_forces(duration, duration);
  if (!model_.actions.empty()) model_.actions.place_loads(model_.blocks);
}

template <int D>
void World<D>::end_motion() {
  const double duration = integrator_.duration();
  hard_contacts_.find_at_end();
  penetration_bound_.note(hard_contacts_.deepest());
  lap(Pass::hard_contacts);

  EnergySample sample = integrator_.kick();
  lap(Pass::motion);
  hard_contacts_.stop_approach(sample, ledger_);
  if (hard_contacts_.is_used()) wake_touched(clock_.time() + duration);
  lap(Pass::hard_contacts);

  note_speeds(sample);
  ledger_.book(sample, duration);
  contacts_.neighbors().tidy_plans();
  lap(Pass::book);
}

/// Predicts the rest of the step: in one motion, or as much of it as fast blocks may make at once.
template <int D>
StepResult World<D>::predict_rest() {
  if (ledger_.is_unstable()) return StepResult::unstable;
  return predict_motion(clock_.rest()) ? divide() : diverged();
}

template <int D>
StepResult World<D>::prepare_and_predict() {
  if (contacts_.has_new_blocks()) make_bonds();
  const StepResult result = prepare();
  return result == StepResult::ok ? predict_rest() : result;
}

/// A changed world finds its contacts and makes its bonds before the memory of the motion is taken: when
/// there is too little, the state before is restored.
template <int D>
StepResult World<D>::predict_changed() {
  renew_neighbors_if_needed();
  contacts_.neighbors().remember_pairs();
  const auto before = copies_of(state(), own_memory());
  try {
    return prepare_and_predict();
  } catch (const std::bad_alloc&) {
    contacts_.neighbors().recall_pairs();
    state() = before;
    throw;
  }
}

/// The predicted motion is not made.
template <int D>
void World<D>::drop_motion() {
  model_.actions.drop_motion(model_.blocks);
  hard_contacts_.drop_motion();
  contacts_.neighbors().forget_announcements();
}

/// Predicts the next motion, unless it cannot be made.
template <int D>
StepResult World<D>::predict_next() {
  try {
    const StepResult result = edited_ || contacts_.has_new_blocks() ? predict_changed() : predict_rest();
    if (result != StepResult::ok) drop_motion();
    return result;
  } catch (const std::bad_alloc&) {
    drop_motion();
    throw;
  }
}

/// One motion, or several where fast blocks divide the step. A step that would take too many, or too many
/// iterations, ends in between, as does one that the host interrupts. It can be continued.
template <int D>
StepResult World<D>::step() {
  drop_plan();
  motions_ = 0;
  first_iteration_ = hard_contacts_.iterations();
  wake(sleep_.wake_in_time(clock_.time(), clock_.time_step()));
  for (;;) {
    const StepResult result = predict_next();
    if (result != StepResult::ok) return result;
    const double duration = integrator_.duration();
    const bool is_last = duration >= clock_.rest();
    move();
    if (is_last) break;
    clock_.pass_part(duration);
    ++motions_;
    if (is_overworked()) return names_fast_pair() ? StepResult::too_fast : StepResult::overworked;
    if (interrupt_ && interrupt_->is_requested()) return StepResult::interrupted;
  }
  clock_.complete_step();
  look_for_sleep();
  return StepResult::ok;
}

#define HALFSPACE_MEMBERS(D)                                \
  template bool World<D>::predict_motion(double);           \
  template void World<D>::predict_actions(double);          \
  template bool World<D>::wake_met(double);                 \
  template StepResult World<D>::diverged() const;           \
  template StepResult World<D>::divide();                   \
  template bool World<D>::choose_time_step();               \
  template void World<D>::note_speeds(const EnergySample&); \
  template StepResult World<D>::prepare();                  \
  template StepResult World<D>::load_changed();             \
  template void World<D>::end_beginning();                  \
  template void World<D>::move();                           \
  template void World<D>::move_and_load();                  \
  template void World<D>::end_motion();                     \
  template StepResult World<D>::predict_rest();             \
  template StepResult World<D>::prepare_and_predict();      \
  template StepResult World<D>::predict_changed();          \
  template void World<D>::drop_motion();                    \
  template StepResult World<D>::predict_next();             \
  template StepResult World<D>::step();

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
