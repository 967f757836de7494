#include "world/hard_contact/hard_contacts.h"

#include "geometry/tolerances.h"
#include "world/hard_contact/limits.h"

namespace halfspace {

template <int D>
void HardContacts<D>::begin(double duration) {
  rests_ = false;
  if (!is_used()) return;
  has_points_ = model_.may_have_points();
  points_.begin();
  rigid_.begin();
  changes().begin(duration);
  rests_ = !has_points_ && rigid_.rests(duration);
  if (rests_) rigid_.hold_blocks();
}

template <int D>
bool HardContacts<D>::predict(double time, double duration) {
  if (!is_used() || rests_) return true;
  if (has_points_) points_.find(time, duration);
  rigid_.find(duration);
  together_.forget_shared();
  next_pause_ = pause_;
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
    // Manifolds alone that have not converged are not worth another search.
    if (searches == max_searches || (!has_converged_ && points_.empty())) return true;
    const bool has_more_points = has_points_ && points_.find_more(time, duration);
    if (!rigid_.find_more(time, duration) && !has_more_points) return true;
  }
}

template <int D>
bool HardContacts<D>::set_gap_targets(double time, double duration, bool is_first_search) {
  rigid_.build();
  if (!points_.empty()) together_.reserve(rigid_.problem());
  if (is_first_search) {
    points_.push(rigid_.impulse_scale(duration));
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
    if (jam()) return false;
    if (!integrator_.predict(duration)) return false;
    const bool are_points_accurate = points_.correct(duration);
    if (!has_converged_ || (rigid_.correct_targets(duration) && are_points_accurate)) break;
    if (!rigid_.empty()) rigid_.set_motions(Half::first);
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

/// If one sweep is not enough, active sets solve the manifolds alone: for blocks far from any point that is
/// the result. If points then unbalance it, the impulses of the last motion are the better start.
template <int D>
bool HardContacts<D>::solve_together(Half half, double duration) {
  ImpulseProblem<D>& problem = rigid_.problem();
  const auto sweep = [&](int max_sweeps) {
    changes().begin(duration);
    rigid_.set_motions(half);
    return together_.solve(problem, points_.constraints(), changes(), rigid_.settings_of(half, duration),
                           max_sweeps);
  };
  together_.keep_start(problem);
  ImpulseResult result = sweep(1);
  const double change = together_.change_of_manifolds();
  if (!result.is_balanced() && next_pause_.ends_now()) {
    together_.return_to_start(problem, points_.constraints());
    rigid_.set_motions(half);
    rigid_.solve(half, duration);
    result = sweep(1);
    if (together_.change_of_manifolds() <= worthwhile * change) {
      next_pause_ = {};
    } else {
      together_.return_to_start(problem, points_.constraints());
      next_pause_.begin_longer();
    }
  }
  if (!result.is_balanced()) result = sweep(max_sweeps_of_points);
  rigid_.take_impulses_beside_points(half, result);
  changes().begin(duration);
  points_.push();
  rigid_.push();
  return result.has_converged;
}

template <int D>
void HardContacts<D>::apply_position_impulses(EnergyLedger& ledger) {
  if (rests_) return;
  rigid_.apply_position_impulses(ledger);
  points_.apply_position_impulses(ledger);
}

template <int D>
void HardContacts<D>::find_at_end() {
  if (rests_) return;
  has_impact_ = !points_.empty() && rigid_.has_impact();
  rigid_.find_at_end(together_.shared());
  points_.find_at_end();
}

template <int D>
void HardContacts<D>::stop_approach(EnergySample& sample, EnergyLedger& ledger) {
  if (!is_used()) return;
  const double duration = integrator_.duration();
  if (rests_) {
    changes().begin(duration);
    rigid_.hold_blocks();
    return integrator_.take_kicks(sample);
  }
  rigid_.set_velocity_targets();
  if (points_.begin_impact(has_impact_)) {
    solve(Half::second, duration);
    points_.end_impact();
  }
  points_.set_velocities();
  solve(Half::second, duration);
  while (rigid_.improve_rebounds()) solve(Half::second, duration);
  rigid_.end_motion(ledger);
  points_.end_motion(ledger);
  pause_ = next_pause_;
  contacts_.note_overlap(rigid_.largest_overlap());
  integrator_.take_kicks(sample);
  contacts_.end_bonds_without_spring();
}

template <int D>
typename HardContacts<D>::BlockLoad HardContacts<D>::load_on(std::size_t slot) const {
  if (!are_loads_summed_) sum_loads();
  return slot < loads_.size() ? loads_[slot] : BlockLoad{Vector<D>::Zero(), Angular<D>::Zero()};
}

template <int D>
void HardContacts<D>::sum_loads() const {
  loads_.clear();
  const auto& position = model_.blocks.position;
  for (const PointContact<D>& at : points_.all()) {
    const Vector<D> arm = place_of(at.of_a, model_.blocks) - position[std::size_t(at.a)];
    add_load(at.a, at.b, {-at.force, arm});
  }
  for (const RigidContact<D>& at : rigid_.all()) add_load(at.a, at.b, rigid_.load_of(at));
  are_loads_summed_ = true;
}

/// Loads of parts act on their compound, too.
template <int D>
void HardContacts<D>::add_load(std::int32_t a, std::int32_t b, const ContactForce<D>& on_b) const {
  const Blocks<D>& blocks = model_.blocks;
  const auto add = [&](std::size_t slot, const Vector<D>& force, const Angular<D>& torque) {
    if (slot >= loads_.size()) loads_.resize(slot + 1, {Vector<D>::Zero(), Angular<D>::Zero()});
    loads_[slot].force += force;
    loads_[slot].torque += torque;
  };
  const auto add_to_both = [&](std::size_t slot, const Vector<D>& force, const Angular<D>& torque) {
    add(slot, force, torque);
    if (blocks.is_part(slot)) add(blocks.mover_of(slot), force, torque + moment(blocks.arm_of(slot), force));
  };
  const Vector<D> to_b = blocks.position[std::size_t(b)] - blocks.position[std::size_t(a)];
  add_to_both(std::size_t(a), -on_b.force, on_b.torque_on_a());
  add_to_both(std::size_t(b), on_b.force, on_b.torque_on_b(to_b));
}

template class HardContacts<2>;
template class HardContacts<3>;

}  // namespace halfspace
