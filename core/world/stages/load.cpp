#include "world/stages/bolt_pass.h"
#include "world/stages/stages.h"

// The stages that load the blocks: contacts first, then what adds to their sums.

namespace halfspace {

template <int D>
Outcome Stages<D>::load_contacts(Motion& motion) {
  renew_neighbors_if_needed();
  contacts_.load(motion.duration, motion.made);
  return Outcome::done;
}

/// The sums of each block. A touched island has slept in this motion: the forces at its end move it. Impulses
/// do so when they stop approach.
template <int D>
Outcome Stages<D>::gather(Motion& motion) {
  contacts_.gather();
  state_.ledger.set_water(0);
  state_.bolt_strain = 0;
  if (!state_.hard_contacts.is_used()) state_.wake_touched(state_.clock.time() + motion.duration);
  return Outcome::done;
}

template <int D>
Outcome Stages<D>::load_by_water(Motion&) {
  state_.ledger.set_water(water_.load());
  return Outcome::done;
}

template <int D>
Outcome Stages<D>::load_by_bolts(Motion&) {
  const BoltEnergy energy = halfspace::load_by_bolts(state_.model, state_.forces);
  state_.bolt_strain = energy.strain;
  state_.ledger.add_contact_strain(energy.strain);
  state_.ledger.add_bolt_loss(energy.loss);
  return Outcome::done;
}

/// Detection includes separated bonds from the next motion on. The failures of bonds belong to the end of
/// this one.
template <int D>
Outcome Stages<D>::load_by_bonds(Motion& motion) {
  BondEnergy energy;
  const Clock& clock = state_.clock;
  if (bonds_.load(clock.steps(), clock.time() + motion.duration, energy))
    state_.contacts.neighbors().invalidate();
  state_.bond_strain = energy.strain;
  state_.ledger.add_contact_strain(energy.strain);
  state_.ledger.add_fracture_loss(energy.fracture_loss);
  state_.ledger.add_friction_loss(energy.friction_loss);
  return Outcome::done;
}

/// Parts pass their loads on to their compounds.
template <int D>
Outcome Stages<D>::load_compounds(Motion&) {
  state_.forces.load_compounds();
  return Outcome::done;
}

/// Loads of tables act at the places that blocks have now.
template <int D>
Outcome Stages<D>::place_loads(Motion&) {
  state_.model.actions.place_loads(state_.model.blocks);
  return Outcome::done;
}

#define HALFSPACE_MEMBERS(D)                           \
  template Outcome Stages<D>::load_contacts(Motion&);  \
  template Outcome Stages<D>::gather(Motion&);         \
  template Outcome Stages<D>::load_by_water(Motion&);  \
  template Outcome Stages<D>::load_by_bolts(Motion&);  \
  template Outcome Stages<D>::load_by_bonds(Motion&);  \
  template Outcome Stages<D>::load_compounds(Motion&); \
  template Outcome Stages<D>::place_loads(Motion&);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
