#include "world/hard_contact/hard_contacts.h"

#include "world/hard_contact/limits.h"

namespace halfspace {

template <int D>
void HardContacts<D>::begin(double duration) {
  if (!is_used()) return;
  has_points_ = model_.may_have_points();
  if (!has_points_) points_.forget();
  changes().begin(duration);
}

template <int D>
bool HardContacts<D>::predict(double time, double duration) {
  if (!is_used()) return true;
  if (has_points_) points_.find(time, duration);
  rigid_.find(duration);
  if ((!points_.empty() || !rigid_.empty()) && !find_impulses(time, duration)) return false;
  points_.reserve();
  rigid_.reserve();
  return true;
}

/// Repeats the search where impulses move blocks to contacts that it has not found. False when the motion
/// diverges.
template <int D>
bool HardContacts<D>::find_impulses(double time, double duration) {
  for (int searches = 1;; ++searches) {
    if (!rigid_.empty() && !set_gap_targets(time, duration, searches == 1)) return false;
    if (!close_gaps(duration)) return false;
    if (searches == max_searches || !has_converged_) return true;
    const bool has_more_points = has_points_ && points_.find_more(time, duration);
    if (!rigid_.find_more(time, duration) && !has_more_points) return true;
  }
}

template <int D>
bool HardContacts<D>::set_gap_targets(double time, double duration, bool is_first_search) {
  rigid_.build();
  if (is_first_search) {
    points_.push();
    rigid_.find_impacts(time, duration);
  }
  changes().begin(duration);
  if (!is_first_search && !integrator_.predict(duration)) return false;
  rigid_.set_gap_targets(duration);
  return true;
}

template <int D>
bool HardContacts<D>::close_gaps(double duration) {
  for (int i = 0; i < max_corrections; ++i) {
    has_converged_ = solve(Half::first, duration);
    if (!integrator_.predict(duration)) return false;
    const bool are_points_accurate = points_.correct(duration);
    if ((rigid_.correct_targets(duration) && are_points_accurate) || !has_converged_) break;
  }
  return true;
}

/// False when the impulses of manifolds do not converge.
template <int D>
bool HardContacts<D>::solve(Half half, double duration) {
  changes().begin(duration);
  if (!points_.empty() && !rigid_.empty()) return solve_together(half, duration);
  points_.solve();
  return rigid_.empty() || rigid_.solve(half, duration);
}

template <int D>
bool HardContacts<D>::solve_together(Half half, double duration) {
  rigid_.set_motions(half);
  const ImpulseResult result =
      together_.solve(rigid_.problem(), points_.constraints(), changes(), rigid_.settings_of(half, duration));
  rigid_.take_impulses(result);
  changes().begin(duration);
  points_.push();
  rigid_.push();
  return result.has_converged;
}

template <int D>
void HardContacts<D>::apply_position_impulses(EnergyLedger& ledger) {
  rigid_.apply_position_impulses(ledger);
  points_.apply_position_impulses(ledger);
}

template <int D>
void HardContacts<D>::find_at_end(EnergyLedger& ledger) {
  rigid_.find_at_end(ledger);
  points_.find_at_end();
}

template <int D>
void HardContacts<D>::stop_approach(EnergySample& sample, EnergyLedger& ledger) {
  if (!is_used()) return;
  const double duration = integrator_.duration();
  points_.set_velocities();
  rigid_.set_velocity_targets();
  solve(Half::second, duration);
  rigid_.end_motion(ledger);
  points_.end_motion(ledger);
  contacts_.note_overlap(rigid_.largest_overlap());
  integrator_.take_kicks(sample);
  contacts_.end_bonds_without_spring();
}

template class HardContacts<2>;
template class HardContacts<3>;

}  // namespace halfspace
