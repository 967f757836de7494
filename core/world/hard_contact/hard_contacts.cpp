#include "world/hard_contact/hard_contacts.h"

namespace halfspace {

template <int D>
void HardContacts<D>::begin(double duration) {
  if (!is_used()) return;
  has_manifolds_ = model_.has_manifolds();
  has_manifolds_ ? points_.forget() : rigid_.forget();
  integrator_.kicks().begin(duration);
}

template <int D>
bool HardContacts<D>::predict(double time, double duration) {
  if (!is_used()) return true;
  return has_manifolds_ ? rigid_.predict(time, duration) : points_.predict(time, duration);
}

template <int D>
void HardContacts<D>::apply_position_impulses(EnergyLedger& ledger) {
  has_manifolds_ ? rigid_.apply_position_impulses(ledger) : points_.apply_position_impulses(ledger);
}

template <int D>
void HardContacts<D>::find_at_end(EnergyLedger& ledger) {
  has_manifolds_ ? rigid_.find_at_end(ledger) : points_.find_at_end();
}

template <int D>
void HardContacts<D>::stop_approach(EnergySample& sample, EnergyLedger& ledger) {
  if (!is_used()) return;
  has_manifolds_ ? rigid_.stop_approach(ledger) : points_.stop_approach(ledger);
  contacts_.note_overlap(rigid_.largest_overlap());
  integrator_.take_kicks(sample);
  contacts_.end_bonds_without_spring();
}

template class HardContacts<2>;
template class HardContacts<3>;

}  // namespace halfspace
