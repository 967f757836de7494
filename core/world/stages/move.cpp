#include "world/stages/stages.h"

// The stages that move the blocks, before and behind those of their loads.

namespace halfspace {

/// Half a kick, and the drift.
template <int D>
Outcome Stages<D>::drift(Motion& motion) {
  state_.model.fix_potential_length();
  if (!state_.model.actions.empty()) state_.ledger.add_outer_power(state_.integrator.power_of_jumps());
  state_.model.actions.accept_motion();
  state_.hard_contacts.apply_position_impulses(state_.ledger);
  state_.integrator.kick_and_drift();
  state_.forget_contacts();
  motion.made = motion.duration;
  return Outcome::done;
}

/// Contacts without springs at the end of the motion.
template <int D>
Outcome Stages<D>::find_impacts(Motion&) {
  state_.hard_contacts.find_at_end();
  state_.penetration_bound.note(state_.hard_contacts.deepest());
  return Outcome::done;
}

/// The second half of the kick.
template <int D>
Outcome Stages<D>::kick(Motion& motion) {
  motion.sample = state_.integrator.kick();
  return Outcome::done;
}

/// The impulses that stop approach. An island that they touch has slept in this motion.
template <int D>
Outcome Stages<D>::stop_approach(Motion& motion) {
  state_.hard_contacts.stop_approach(motion.sample, state_.ledger);
  state_.wake_touched(state_.clock.time() + motion.duration);
  return Outcome::done;
}

/// The ledger takes the energies after the motion.
template <int D>
Outcome Stages<D>::book(Motion& motion) {
  state_.note_speeds(motion.sample);
  state_.ledger.book(motion.sample, motion.duration);
  return Outcome::done;
}

#define HALFSPACE_MEMBERS(D)                          \
  template Outcome Stages<D>::drift(Motion&);         \
  template Outcome Stages<D>::find_impacts(Motion&);  \
  template Outcome Stages<D>::kick(Motion&);          \
  template Outcome Stages<D>::stop_approach(Motion&); \
  template Outcome Stages<D>::book(Motion&);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
