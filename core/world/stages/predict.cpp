#include <algorithm>

#include "geometry/tolerances.h"
#include "world/stages/stages.h"

// The stages that predict a motion, and take all its memory, so that a motion once begun completes.

namespace halfspace {
namespace {

/// No motion is a smaller part of a step, and none that ends at an impact is smaller than this.
constexpr double min_part = 0x1p-24, min_located_part = 0x1p-16;

/// Rebounds that follow each other ever faster would divide a step without end: after so many motions impacts
/// are no longer located in it.
constexpr int max_located_motions = 64;

/// An impact that passes from block to block lengthens motions each time.
constexpr int max_renewals = 16;

Outcome refuse(StepResult why, Motion& motion) {
  motion.result = why;
  return Outcome::refused;
}

}  // namespace

template <int D>
Outcome Stages<D>::diverged(Motion& motion) const {
  return refuse(state_.integrator.inverted().body >= 0 ? StepResult::inverted : StepResult::unstable, motion);
}

/// Sets the loads and velocities that tables give for the coming motion.
template <int D>
Outcome Stages<D>::predict_actions(Motion& motion) {
  Actions<D>& actions = state_.model.actions;
  for (auto& target : actions.targets()) {
    if (!target.is_servo) continue;
    const auto contacts = state_.stable_step.sum_over_contacts_of(target.slot);
    target.servo.adapt(contacts.stiffness, contacts.viscosity, motion.duration, state_.clock.time_step());
  }
  actions.predict({state_.clock.time(), motion.duration}, state_.model.blocks);
  state_.integrator.take_actions(motion.duration);
  return Outcome::done;
}

/// Half a kick and a drift, without the impulses of contacts.
template <int D>
Outcome Stages<D>::predict(Motion& motion) {
  state_.hard_contacts.begin(motion.duration);
  return state_.integrator.predict(motion.duration) ? Outcome::done : diverged(motion);
}

/// The neighbour list is renewed if the motion would use it up.
template <int D>
Outcome Stages<D>::search(Motion& motion) {
  if (state_.contacts.neighbors().needs_rebuild()) renew_neighbors(motion.renewals);
  return Outcome::done;
}

/// Wakes islands that blocks without springs meet in the coming motion: impulses act on both.
template <int D>
Outcome Stages<D>::wake_met(Motion& motion) {
  const auto meetings = [&](auto visit) { state_.hard_contacts.for_each_meeting(motion.duration, visit); };
  return state_.sleep.wake_touched(meetings, state_.clock.time()) ? predict(motion) : Outcome::done;
}

template <int D>
Outcome Stages<D>::predict_impulses(Motion& motion) {
  if (!state_.hard_contacts.predict(state_.clock.time(), motion.duration)) return diverged(motion);
  if (!state_.contacts.neighbors().needs_rebuild()) return Outcome::done;
  if (++motion.renewals == max_renewals) return diverged(motion);
  renew_neighbors(motion.renewals);
  return Outcome::relisted;
}

/// Shortens the predicted motion until it can be made at once: no block turns by more than an angle whose arc
/// is as long as its radius, no fast pair overlaps deeply, and impacts that are located are at its end.
template <int D>
Outcome Stages<D>::divide(Motion& motion) {
  const Integrator<D>& integrator = state_.integrator;
  const double step = state_.clock.time_step();
  double part = 1;
  if (integrator.max_rotation() > max_turn) {
    part = 0.9 * max_turn / integrator.max_rotation();
  } else if (state_.continuous_collision.any()) {
    part = state_.continuous_collision.safe_fraction();
    if (part < 1 && state_.model.settings.fast_blocks == FastBlocks::refuse)
      return refuse(StepResult::too_fast, motion);
  }
  // Impacts that follow each other without end are not told apart.
  const double before_impact = state_.hard_contacts.fraction_before_impact();
  if (motions_ < max_located_motions && before_impact * motion.duration >= min_located_part * step)
    part = std::min(part, before_impact);
  if (part >= whole_part) return Outcome::done;
  if (!(part * motion.duration >= min_part * step)) return refuse(StepResult::unstable, motion);
  if (is_overworked()) return refuse(StepResult::overworked, motion);
  motion.duration *= part;
  motion.renewals = 0;
  return Outcome::shortened;
}

#define HALFSPACE_MEMBERS(D)                             \
  template Outcome Stages<D>::diverged(Motion&) const;   \
  template Outcome Stages<D>::predict_actions(Motion&);  \
  template Outcome Stages<D>::predict(Motion&);          \
  template Outcome Stages<D>::search(Motion&);           \
  template Outcome Stages<D>::wake_met(Motion&);         \
  template Outcome Stages<D>::predict_impulses(Motion&); \
  template Outcome Stages<D>::divide(Motion&);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
