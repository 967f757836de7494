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
constexpr double least_part = 0x1p-24;

/// A blow that is passed on from block to block lengthens motions each time.
constexpr int most_renewals = 16;

constexpr double largest_double = std::numeric_limits<double>::max();

}  // namespace

/// Plans the coming motion: false when it is out of hand. Brings the neighbour list up to date when the
/// motion would use it up. All memory is taken here, so that a motion once begun is finished.
template <int D>
bool World<D>::plan_motion(double duration) {
  if (reactions_.is_wanted()) integrator_.kicks().begin(duration);
  if (!integrator_.plan(duration)) return false;
  if (contacts_.neighbors().used_up()) {
    lap(Pass::motion);
    renew_neighbors();
    lap(Pass::search);
  }
  if (!reactions_.is_wanted()) return true;
  lap(Pass::motion);
  const bool is_planned = plan_reactions(duration);
  lap(Pass::reactions);
  return is_planned;
}

/// A block that is struck may go farther than its neighbour list has been told: then it is made anew, and the
/// blows with it.
template <int D>
bool World<D>::plan_reactions(double duration) {
  for (int i = 0; i < most_renewals; ++i) {
    if (!reactions_.plan(clock_.time(), duration)) return false;
    if (!contacts_.neighbors().used_up()) return true;
    renew_neighbors();
    integrator_.kicks().begin(duration);
    if (!integrator_.plan(duration)) return false;
  }
  return false;
}

/// The result of a step whose motion cannot be planned.
template <int D>
StepResult World<D>::out_of_hand() const {
  return inverted_cell().body >= 0 ? StepResult::inverted : StepResult::unstable;
}

/// Shortens the planned motion until it is one that can be made at once: no block turns by more than an angle
/// whose arc is as long as its radius, and no fast pair enters deep.
template <int D>
StepResult World<D>::divide() {
  for (;;) {
    double part = 1;
    if (integrator_.most_turned() > most_turn) {
      part = 0.9 * most_turn / integrator_.most_turned();
    } else if (fast_motion_.any()) {
      part = fast_motion_.calm_part();
      if (part < 1 && model_.settings.fast_blocks == FastBlocks::refuse) return StepResult::too_fast;
    }
    if (part >= 1) return StepResult::ok;
    if (!(part * integrator_.duration() >= least_part * clock_.time_step())) return StepResult::unstable;
    if (!plan_motion(part * integrator_.duration())) return out_of_hand();
  }
}

template <int D>
bool World<D>::choose_time_step() {
  if (model_.settings.time_step != 0) return clock_.choose(model_.settings.time_step);
  detect();  // the contacts that are there count
  const double stable = model_.settings.safety * stable_step_.bound();
  // One that is divided where blocks are fast need not know of speeds.
  return clock_.choose(model_.settings.fast_blocks == FastBlocks::refuse
                           ? std::min(stable, fast_motion_.calm_time_step())
                           : stable);
}

template <int D>
void World<D>::note_speeds(const Stock& stock) {
  // One beyond all numbers is the largest.
  peak_speed_ = std::max(peak_speed_, std::min(std::sqrt(stock.squared_speed), largest_double));
  fast_motion_.note_speeds(stock);
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
  const Stock stock = integrator_.begin(clock_.time_step(), noise);
  note_speeds(stock);
  ledger_.begin(stock, noise);
  edited_ = false;
  return StepResult::ok;
}

/// From where forces are known to where they are known again.
template <int D>
void World<D>::move() {
  const double duration = integrator_.duration();
  model_.fix_potential_length();
  if (reactions_.is_wanted()) reactions_.book_first(ledger_);
  integrator_.kick_and_drift();
  forget_contacts();
  made_ = duration;
  lap(Pass::motion);
  evaluate_forces(duration);
  made_ = 0;
  if (reactions_.is_wanted()) {
    reactions_.look();
    spring_stop_.note(reactions_.deepest());
    lap(Pass::reactions);
  }
  Stock stock = integrator_.kick();
  lap(Pass::motion);
  if (reactions_.is_wanted()) {
    reactions_.stop(stock, ledger_);
    lap(Pass::reactions);
  }
  note_speeds(stock);
  ledger_.book(stock, duration);
  contacts_.neighbors().tidy_plans();
  lap(Pass::book);
}

/// Plans what is left of the step: in one go, or as much of it as fast blocks may do at once.
template <int D>
StepResult World<D>::plan_rest() {
  if (ledger_.makes_energy()) return StepResult::unstable;
  return plan_motion(clock_.rest()) ? divide() : out_of_hand();
}

template <int D>
StepResult World<D>::prepare_and_plan() {
  if (contacts_.has_fresh()) make_bonds();
  const StepResult result = prepare();
  return result == StepResult::ok ? plan_rest() : result;
}

/// A changed world finds its contacts and makes its bonds before it shows how much memory the motion takes:
/// when there is too little, what was known before is put back.
template <int D>
StepResult World<D>::plan_changed() {
  renew_used_up_neighbors();
  contacts_.neighbors().remember_pairs();
  const auto before = copies_of(state(), model_.blocks.kind.get_allocator().resource());
  try {
    return prepare_and_plan();
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
  StepResult result = edited_ || contacts_.has_fresh() ? plan_changed() : plan_rest();
  for (;; result = plan_rest()) {
    if (result != StepResult::ok) return result;
    const double duration = integrator_.duration();
    const bool is_last = duration >= clock_.rest();
    move();
    if (is_last) break;
    clock_.pass_part(duration);
    if (++motions == most_motions) return fast_motion_.any() ? StepResult::too_fast : StepResult::unstable;
  }
  clock_.complete_step();
  look_for_sleep();
  return StepResult::ok;
}

#define HALFSPACE_MEMBERS(D)                         \
  template bool World<D>::plan_motion(double);       \
  template bool World<D>::plan_reactions(double);    \
  template StepResult World<D>::out_of_hand() const; \
  template StepResult World<D>::divide();            \
  template bool World<D>::choose_time_step();        \
  template void World<D>::note_speeds(const Stock&); \
  template StepResult World<D>::prepare();           \
  template void World<D>::move();                    \
  template StepResult World<D>::plan_rest();         \
  template StepResult World<D>::prepare_and_plan();  \
  template StepResult World<D>::plan_changed();      \
  template StepResult World<D>::step();

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
