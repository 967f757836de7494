#include <algorithm>
#include <limits>
#include <new>

#include "world/copies.h"
#include "world/world.h"

// A step of velocity Verlet, in one motion or in several where fast blocks divide it:
//
//   plan    half a kick and a drift are worked out; the neighbour list is renewed if they would use it up
//   divide  the motion is shortened until no block turns too far and no fast pair enters deep
//   move    kick and drift; find and describe contacts; load; gather; kick
//   book    the ledger takes the stock of energies after the motion

namespace halfspace {
namespace {

/// No motion is a smaller part of a step.
constexpr double min_part = 0x1p-24;

/// A blow that is passed on from block to block lengthens motions each time.
constexpr int max_renewals = 16;

constexpr double largest_double = std::numeric_limits<double>::max();

}  // namespace

/// Plans the coming motion: false when it is out of hand. Brings the neighbour list up to date when the
/// motion would use it up. All memory is taken here, so that a motion once begun is finished.
template <int D>
bool World<D>::predict_motion(double duration) {
  if (hard_contacts_.is_wanted()) integrator_.kicks().begin(duration);
  if (!integrator_.predict(duration)) return false;
  if (contacts_.neighbors().needs_rebuild()) {
    lap(Pass::motion);
    renew_neighbors();
    lap(Pass::search);
  }
  if (!hard_contacts_.is_wanted()) return true;
  lap(Pass::motion);
  const bool is_planned = predict_hard_contacts(duration);
  lap(Pass::reactions);
  return is_planned;
}

/// A block that is struck may go farther than its neighbour list has been told: then it is made anew, and the
/// blows with it.
template <int D>
bool World<D>::predict_hard_contacts(double duration) {
  for (int i = 0; i < max_renewals; ++i) {
    if (!hard_contacts_.predict(clock_.time(), duration)) return false;
    if (!contacts_.neighbors().needs_rebuild()) return true;
    renew_neighbors();
    integrator_.kicks().begin(duration);
    if (!integrator_.predict(duration)) return false;
  }
  return false;
}

/// The result of a step whose motion cannot be planned.
template <int D>
StepResult World<D>::diverged() const {
  return inverted_cell().body >= 0 ? StepResult::inverted : StepResult::unstable;
}

/// Shortens the planned motion until it is one that can be made at once: no block turns by more than an angle
/// whose arc is as long as its radius, and no fast pair enters deep.
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
    if (part >= 1) return StepResult::ok;
    if (!(part * integrator_.duration() >= min_part * clock_.time_step())) return StepResult::unstable;
    if (!predict_motion(part * integrator_.duration())) return diverged();
  }
}

template <int D>
bool World<D>::choose_time_step() {
  if (model_.settings.time_step != 0) return clock_.choose(model_.settings.time_step);
  detect();  // the contacts that are there count
  const double stable = model_.settings.safety * stable_step_.bound();
  // One that is divided where blocks are fast need not know of speeds.
  return clock_.choose(model_.settings.fast_blocks == FastBlocks::refuse
                           ? std::min(stable, continuous_collision_.safe_time_step())
                           : stable);
}

template <int D>
void World<D>::note_speeds(const EnergySample& sample) {
  // One beyond all numbers is the largest.
  peak_speed_ = std::max(peak_speed_, std::min(std::sqrt(sample.squared_speed), largest_double));
  continuous_collision_.note_speeds(sample);
}

template <int D>
StepResult World<D>::prepare() {
  if (!edited_) return StepResult::ok;
  // Memory of blocks is taken first, that of pairs by detection: contacts are found only when there is all of
  // it.
  const std::size_t slots = model_.blocks.slot_count();
  stable_step_.reserve(slots);
  integrator_.reserve(slots);
  if (model_.settings.sleep_tolerance > 0) sleep_.reserve(slots);
  if (!choose_time_step()) return StepResult::no_time_step;
  integrator_.resize(slots);
  if (model_.settings.sleep_tolerance > 0) sleep_.resize(slots);
  evaluate_forces(0);
  double noise = 0;
  const EnergySample sample = integrator_.begin(clock_.time_step(), noise);
  note_speeds(sample);
  ledger_.begin(sample, noise);
  edited_ = false;
  return StepResult::ok;
}

/// From where forces are known to where they are known again.
template <int D>
void World<D>::move() {
  const double duration = integrator_.duration();
  model_.fix_potential_length();
  if (hard_contacts_.is_wanted()) hard_contacts_.apply_position_impulses(ledger_);
  integrator_.kick_and_drift();
  forget_contacts();
  made_ = duration;
  lap(Pass::motion);
  evaluate_forces(duration);
  made_ = 0;
  if (hard_contacts_.is_wanted()) {
    hard_contacts_.look();
    penetration_bound_.note(hard_contacts_.deepest());
    lap(Pass::reactions);
  }
  EnergySample sample = integrator_.kick();
  lap(Pass::motion);
  if (hard_contacts_.is_wanted()) {
    hard_contacts_.stop(sample, ledger_);
    lap(Pass::reactions);
  }
  note_speeds(sample);
  ledger_.book(sample, duration);
  contacts_.neighbors().tidy_plans();
  lap(Pass::book);
}

/// Plans what is left of the step: in one go, or as much of it as fast blocks may do at once.
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

/// A changed world finds its contacts and makes its bonds before it shows how much memory the motion takes:
/// when there is too little, what was known before is put back.
template <int D>
StepResult World<D>::predict_changed() {
  renew_neighbors_if_needed();
  contacts_.neighbors().remember_pairs();
  const auto before = copies_of(state(), model_.blocks.kind.get_allocator().resource());
  try {
    return prepare_and_predict();
  } catch (const std::bad_alloc&) {
    contacts_.neighbors().recall_pairs();
    state() = before;
    throw;
  }
}

/// Motion by motion: one, unless fast blocks divide the step. What would take very many is refused where it
/// has come to, and may be gone on with.
template <int D>
StepResult World<D>::step() {
  int motions = 0;
  wake(sleep_.wake_in_time(clock_.time(), clock_.time_step()));
  StepResult result = edited_ || contacts_.has_new_blocks() ? predict_changed() : predict_rest();
  for (;; result = predict_rest()) {
    if (result != StepResult::ok) return result;
    const double duration = integrator_.duration();
    const bool is_last = duration >= clock_.rest();
    move();
    if (is_last) break;
    clock_.pass_part(duration);
    if (++motions == max_motions)
      return continuous_collision_.any() ? StepResult::too_fast : StepResult::unstable;
  }
  clock_.complete_step();
  look_for_sleep();
  return StepResult::ok;
}

#define HALFSPACE_MEMBERS(D)                                \
  template bool World<D>::predict_motion(double);           \
  template bool World<D>::predict_hard_contacts(double);    \
  template StepResult World<D>::diverged() const;           \
  template StepResult World<D>::divide();                   \
  template bool World<D>::choose_time_step();               \
  template void World<D>::note_speeds(const EnergySample&); \
  template StepResult World<D>::prepare();                  \
  template void World<D>::move();                           \
  template StepResult World<D>::predict_rest();             \
  template StepResult World<D>::prepare_and_predict();      \
  template StepResult World<D>::predict_changed();          \
  template StepResult World<D>::step();

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
