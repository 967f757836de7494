#include "world/hard_contact/rigid_contacts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "geometry/tolerances.h"
#include "world/hard_contact/limits.h"

namespace halfspace {
namespace {

constexpr int max_recovery_sweeps = 10;

}  // namespace

/// Impulses of the last motion at the same places, by either block: on a flush face the points may have
/// changed their order and their owner. Those of rest would grow with the duration, and those of an impact do
/// not: from 4e4 times these, as after the short last part of a divided step, sweeps found no way back.
template <int D>
void RigidContacts<D>::warm_start(double duration) {
  const double scale = std::min(1.0, impulse_scale(duration));
  auto before = known_.begin();
  for (PredictedContact<D>& contact : predicted_) {
    while (before != known_.end() && before->blocks() < contact.blocks()) ++before;
    contact.is_new = before == known_.end() || before->blocks() != contact.blocks();
    if (contact.is_new) continue;
    contact.touched_at = before->touched_at;
    contact.friction = scale * before->friction;
    contact.couple = scale * before->couple;
    if (contact.is_kept) {
      for (std::size_t i = 0; i < std::size_t(contact.manifold.count); ++i) {
        contact.impulse[i] = scale * before->impulse[i];
        contact.was_loaded[i] = before->impulse[i] > 0;
      }
      continue;
    }
    const PosedBlock<D> a = search_.now(std::size_t(contact.a)), b = search_.now(std::size_t(contact.b));
    const double near = same_point * search_.smaller_radius(contact);
    for (std::size_t i = 0; i < std::size_t(contact.manifold.count); ++i) {
      double nearest = near * near;
      for (std::size_t k = 0; k < std::size_t(before->manifold.count); ++k) {
        const double distance =
            (arm_of(contact.manifold, i, a, b) - arm_of(before->manifold, k, a, b)).squaredNorm();
        if (distance >= nearest) continue;
        nearest = distance;
        contact.impulse[i] = scale * before->impulse[k];
        contact.was_loaded[i] = before->impulse[k] > 0;
      }
    }
  }
}

/// The second half step finds the unbalanced velocity of the first one twice. At half of the tolerance, both
/// stay within it.
template <int D>
ImpulseSettings RigidContacts<D>::settings_of(Half half, double duration) const {
  const double fraction = half == Half::first ? 0.5 : 1;
  return {.tolerance = fraction * model_.settings.impulse_tolerance,
          .tolerance_of_rest = fraction * tolerance_of_rest(),
          .speed = duration * model_.settings.gravity.norm(),
          .max_iterations = model_.settings.max_impulse_iterations};
}

template <int D>
std::optional<Jam> RigidContacts<D>::find_jam(Half half, double ratio) {
  const auto free = [&](std::size_t i) { return motion_in(half, i); };
  return halfspace::find_jam(problem_, blocks_, free, 1 / changes().rate(), ratio);
}

template <int D>
double RigidContacts<D>::tolerance_of_rest() const {
  return std::min(model_.settings.impulse_tolerance, tolerance_to_stand);
}

/// Slower blocks stand: several contacts of a block may each leave the tolerance unbalanced.
template <int D>
double RigidContacts<D>::standing_speed(double tolerance, double duration) const {
  constexpr double contacts = 4;
  return contacts * tolerance * duration * model_.settings.gravity.norm();
}

/// Do the impulses of the last motion hold all blocks?
template <int D>
bool RigidContacts<D>::stands(Half half, double duration) {
  const double speed = standing_speed(tolerance_of_rest(), duration);
  return !model_.may_have_points() && rest_.may_hold_all(half, speed) &&
         solver_.is_solved(problem_, settings_of(half, duration)) && rest_.hold_all(half, problem_, speed);
}

/// Impulses that have not converged, and lack more work than they make, may be those of a jam.
template <int D>
bool RigidContacts<D>::solve(Half half, double duration) {
  jam_.reset();
  if (stands(half, duration)) return true;
  const ImpulseResult result = solver_.solve(problem_, settings_of(half, duration));
  if (!result.has_converged && find_jam(half, 1)) {
    jam_ =
        solver_.ask_after_sweeps(problem_, sweeps_of_suspect, [&] { return find_jam(half, jammed_ratio); });
    next_iterations_ += sweeps_of_suspect;
  }
  take_impulses(result);
  push();
  if (!model_.may_have_points())
    rest_.hold_islands(half, problem_, standing_speed(tolerance_of_rest(), duration));
  return result.has_converged;
}

template <int D>
void RigidContacts<D>::take_impulses_beside_points(Half half, const ImpulseResult& result) {
  jam_.reset();
  if (!result.has_converged) jam_ = find_jam(half, jammed_ratio);
  take_impulses(result);
}

/// The work of a jam's impulses would be without bound: the run ends where the next motion cannot be made.
template <int D>
void RigidContacts<D>::take_impulses(const ImpulseResult& result) {
  if (jam_) {
    for (ImpulseRow<D>& row : problem_.rows) row.impulse = 0;
  }
  next_iterations_ += result.iterations;
  next_unbalanced_velocity_ = std::max(next_unbalanced_velocity_, result.unbalanced);
  std::size_t c = 0;
  for (PredictedContact<D>& contact : predicted_) {
    const ImpulseContact<D>& of = problem_.contacts[c++];
    std::size_t i = 0;
    const double part = solves_whole() ? 0.5 : 1;
    for (const ImpulseRow<D>& row : problem_.normals_of(of)) contact.impulse[i++] = part * row.impulse;
    contact.friction = problem_.friction_impulse(of);
    contact.couple = part * twist_about_middle(of, contact);
    contact.friction *= part;
  }
}

/// The moment of friction about the normal through the middle of the points, by the rows' moments about a.
template <int D>
double RigidContacts<D>::twist_about_middle(const ImpulseContact<D>& of, const RigidContact<D>& contact) {
  if constexpr (D == 2) {
    return 0;
  } else {
    const std::span<const ImpulseRow<D>> normals = problem_.normals_of(of);
    Angular<D> turn = Angular<D>::Zero(), of_middle = Angular<D>::Zero();
    for (const ImpulseRow<D>& row : problem_.frictions_of(of)) turn += row.impulse * row.turn_a;
    for (const ImpulseRow<D>& row : normals) of_middle += row.turn_a / double(normals.size());
    return contact.normal.dot(turn) + contact.friction.dot(of_middle);
  }
}

template <int D>
void RigidContacts<D>::push() const {
  for (std::size_t c = 0; c < predicted_.size(); ++c) {
    const ImpulseContact<D>& of = problem_.contacts[c];
    Vector<D> impulse = Vector<D>::Zero();
    Angular<D> turn_a = Angular<D>::Zero(), turn_b = Angular<D>::Zero();
    for_each_impulse(c, [&](const ImpulseRow<D>& row, double size, bool) {
      impulse += size * row.direction;
      turn_a += size * row.turn_a;
      turn_b += size * row.turn_b;
    });
    if (search_.is_free(std::size_t(of.a))) changes().push(std::size_t(of.a), -impulse, -turn_a);
    if (search_.is_free(std::size_t(of.b))) changes().push(std::size_t(of.b), impulse, turn_b);
  }
}

/// As it is now.
template <int D>
BlockMotion<D> RigidContacts<D>::motion(std::size_t i) const {
  return can_move(i) ? BlockMotion<D>{blocks_.velocity[i], blocks_.spin[i]} : BlockMotion<D>{};
}

/// Without impulses.
template <int D>
BlockMotion<D> RigidContacts<D>::motion_in(Half half, std::size_t i) const {
  const bool is_ahead =
      half == Half::first && (search_.is_free(i) || blocks_.kind[i] == BlockKind::prescribed);
  return is_ahead ? integrator_.motion_at_half_step(i) : motion(i);
}

template <int D>
void RigidContacts<D>::set_motions(Half half) {
  problem_.motions.assign(blocks_.slot_count(), {});
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i) problem_.motions[i] = motion_in(half, i);
  if (half == Half::second && solves_whole()) take_back_first_impulses();
}

template <int D>
void RigidContacts<D>::set_start(Half half) {
  problem_.slow_slip = slow_fraction * integrator_.duration() * model_.settings.gravity.norm();
  problem_.start.assign(blocks_.slot_count(), {});
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i)
    problem_.start[i] =
        half == Half::first || !can_move(i) ? motion(i) : integrator_.motion_half_a_step_ago(i);
}

template <int D>
void RigidContacts<D>::find(double duration) {
  next_unbalanced_velocity_ = 0;
  fraction_before_impact_ = 1;
  rest_.note_slow(standing_speed(model_.settings.impulse_tolerance, duration), problem_.is_slow);
  solver_.set_pauses(pauses_);
  search_.find(duration, known_, predicted_);
  for (PredictedContact<D>& contact : predicted_) search_.set_gaps(contact);
  warm_start(duration);
}

template <int D>
void RigidContacts<D>::build() {
  first_.contacts.clear();
  set_start(Half::first);
  rows_.build(predicted_, problem_);
  set_motions(Half::first);
  problem_.find_islands();
  problem_.rows.reserve(max_rows(problem_));
  solver_.reserve(problem_);
  rest_.reserve(blocks_.slot_count());
}

template <int D>
bool RigidContacts<D>::find_more(double time, double duration) {
  if (!search_.find_more(predicted_)) return false;
  for (PredictedContact<D>& contact : predicted_) {
    if (contact.is_new && contact.touched_at == 0) contact.touched_at = time + duration;
  }
  return true;
}

/// The work of a contact's impulses: of the normal ones a loss by impact, of friction a loss by friction, on
/// prescribed blocks work from outside. Returns the loss by impact.
template <int D>
double RigidContacts<D>::book(std::size_t c, EnergyLedger& ledger) {
  const ImpulseWork work = work_of(c);
  ledger.add_outer_work(work.outer);
  impact_loss_ -= work.normal;
  friction_loss_ -= work.friction;
  whole_work_ += std::abs(work.normal) + std::abs(work.friction);
  predicted_[c].work.add(work);
  return -work.normal;
}

/// Contacts at rest gain in the first half of a motion what they lose in the second, so only the losses of a
/// whole motion count. Friction that does work in an impact lessens the loss by the impact. What impulses
/// gain together beyond the tolerance of the solver is an error of the method: it is part of the residual.
template <int D>
void RigidContacts<D>::book_motion(EnergyLedger& ledger) {
  if (rest_.holds_all()) return;  // what the works lack is within the tolerance
  const double whole_loss = impact_loss_ + friction_loss_, friction_loss = std::max(friction_loss_, 0.0);
  const bool makes_energy = whole_loss < -model_.settings.impulse_tolerance * whole_work_;
  ledger.add_friction_loss(friction_loss);
  ledger.add_impact_loss(makes_energy ? -friction_loss : whole_loss - friction_loss);
}

template <int D>
void RigidContacts<D>::apply_position_impulses(EnergyLedger& ledger) {
  impact_loss_ = friction_loss_ = whole_work_ = 0;
  for (std::size_t c = 0; c < predicted_.size(); ++c) predicted_[c].impact_loss = book(c, ledger);
  keep_first_impulses();
}

/// Moves blocks apart that overlap, without a change of their velocities. Returns the change of their
/// potential energy. It aims at half of the overlap that is settled, so that it comes to an end.
template <int D>
double RigidContacts<D>::recover(std::span<const std::size_t> held_by_points) {
  const auto overlaps = [&](const PredictedContact<D>& contact) {
    return contact.min_gap() < -search_.settled_gap(contact);
  };
  if (std::none_of(predicted_.begin(), predicted_.end(), overlaps)) return 0;
  rest_.begin();
  rows_.build_normals(predicted_, problem_, held_by_points);
  std::fill_n(problem_.motions.begin(), blocks_.moving_end(), BlockMotion<D>());  // displacements
  for (std::size_t c = 0; c < predicted_.size(); ++c) {
    const PredictedContact<D>& contact = predicted_[c];
    if (!problem_.can_move(problem_.contacts[c])) problem_.contacts[c].normal_count = 0;
    const std::span<ImpulseRow<D>> rows = problem_.normals_of(problem_.contacts[c]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].impulse = 0;
      rows[i].target = -std::max(0.0, contact.gap[i]) +
                       recovered_part * std::max(0.0, -contact.gap[i] - 0.5 * search_.settled_gap(contact));
    }
  }
  solver_.sweep_only(problem_, std::min(max_recovery_sweeps, model_.settings.max_impulse_iterations));
  double energy = 0;
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i) {
    const BlockMotion<D>& displacement = problem_.motions[i];
    if (displacement.velocity.isZero(0) && displacement.spin.isZero(0)) continue;
    integrator_.displace(i, displacement);
    energy -= blocks_.mass[i] * model_.settings.gravity.dot(displacement.velocity);
  }
  for (PredictedContact<D>& contact : predicted_) search_.set_gaps(contact);
  return energy;
}

template <int D>
bool RigidContacts<D>::has_impact() const {
  if (predicted_.empty()) return false;  // the problem is that of an earlier motion
  const double slow = slow_fraction * integrator_.duration() * model_.settings.gravity.norm();
  return std::any_of(problem_.contacts.begin(), problem_.contacts.end(), [&](const ImpulseContact<D>& of) {
    const BlockMotion<D> a = motion(std::size_t(of.a)), b = motion(std::size_t(of.b));
    const std::span<const ImpulseRow<D>> rows = problem_.rows_of(of).first(std::size_t(of.normal_count));
    return std::any_of(rows.begin(), rows.end(), [&](const ImpulseRow<D>& row) {
      return row.impulse > 0 && row.velocity(a, b) < -slow;
    });
  });
}

template <int D>
void RigidContacts<D>::find_at_end(std::span<const std::size_t> held_by_points) {
  for (PredictedContact<D>& contact : predicted_) search_.set_gaps(contact);
  impact_loss_ -= recover(held_by_points);
  for (PredictedContact<D>& contact : predicted_) {
    contact.is_apart =
        !(contact.normal_impulse() > 0) && !contact.rebounds() && contact.min_gap() > search_.reach(contact);
    for (std::size_t i = 0; i < std::size_t(contact.manifold.count); ++i) {
      const double depth = -contact.gap[i] / blocks_.thinner(contact.a, contact.b);
      if (depth > converged_gap) deepest_ = std::max(deepest_, depth);
    }
  }
}

template <int D>
void RigidContacts<D>::end_motion(EnergyLedger& ledger) {
  const double duration = integrator_.duration();
  for (std::size_t c = 0; c < predicted_.size(); ++c) {
    predicted_[c].impact_loss += book(c, ledger);
    touches_ += predicted_[c].is_new && !predicted_[c].is_apart;
  }
  book_motion(ledger);
  std::erase_if(predicted_, [](const PredictedContact<D>& contact) { return contact.is_apart; });
  rest_.end(duration, are_contacts_kept());
  replace_known(duration);
  keep_pauses();
  iterations_ += std::exchange(next_iterations_, 0);
  unbalanced_velocity_ = next_unbalanced_velocity_;
  predicted_.clear();
  first_.contacts.clear();
  duration_ = duration;
}

/// Blocks that stand or have no contact begin anew. The velocities still lack the last impulses.
template <int D>
void RigidContacts<D>::keep_pauses() {
  pauses_.assign(blocks_.moving_end(), {});
  if (predicted_.empty()) return;
  for (std::size_t i = 0; i < pauses_.size(); ++i) {
    const bool stands = (blocks_.velocity[i] + changes().of_block(i)).isZero(0) &&
                        (blocks_.momentum[i] + changes().momentum(i)).isZero(0);
    if (!stands && problem_.islands.of_block(std::int32_t(i)) >= 0) pauses_[i] = solver_.pauses()[i];
  }
}

/// None is new, and none has ended.
template <int D>
bool RigidContacts<D>::are_contacts_kept() const {
  const auto is_old = [](const PredictedContact<D>& contact) { return !contact.is_new; };
  const auto is_awake = [&](const RigidContact<D>& contact) {
    return !integrator_.sleep().leaves_out(contact);
  };
  return std::all_of(predicted_.begin(), predicted_.end(), is_old) &&
         std::count_if(known_.begin(), known_.end(), is_awake) == std::ptrdiff_t(predicted_.size());
}

/// Contacts of the last motion replace the known ones. Those of sleeping blocks stay, with their forces.
template <int D>
void RigidContacts<D>::replace_known(double duration) {
  std::erase_if(known_,
                [&](const RigidContact<D>& contact) { return !integrator_.sleep().leaves_out(contact); });
  const double scale = impulse_scale(duration);
  for (RigidContact<D>& contact : known_) {
    for (double& impulse : contact.impulse) impulse *= scale;
    contact.friction *= scale;
    contact.couple *= scale;
    contact.impact_loss = 0;
  }
  next_known_.clear();
  std::merge(known_.begin(), known_.end(), predicted_.begin(), predicted_.end(),
             std::back_inserter(next_known_), is_before<D>);
  known_.swap(next_known_);
}

template <int D>
void RigidContacts<D>::note_pressed(PressedPair& pair) const {
  const auto note = [&](const auto& contacts, double rate) {
    for (const RigidContact<D>& at : contacts) pair.note(at.a, at.b, rate * at.normal_impulse());
  };
  if (predicted_.empty()) {
    if (duration_ > 0) note(known_, 2 / duration_);
  } else {
    note(predicted_, changes().rate());
  }
}

template <int D>
double RigidContacts<D>::largest_overlap() const {
  double overlap = 0;
  for (const RigidContact<D>& contact : known_) overlap = std::max(overlap, -contact.min_gap());
  return overlap;
}

/// At the centre of the normal impulses.
template <int D>
ContactForce<D> RigidContacts<D>::load_of(const RigidContact<D>& contact) const {
  const PosedBlock<D> a = search_.now(std::size_t(contact.a)), b = search_.now(std::size_t(contact.b));
  const Arms<D> arm = arms_of(contact.manifold, a, b);
  ContactForce<D> load;
  load.point = center_of_impulses(contact, arm);
  if (!(duration_ > 0)) return load;
  const double rate = 2 / duration_;
  load.force = rate * (contact.normal_impulse() * contact.normal + contact.friction);
  if constexpr (D == 3) {
    const Vector<D> from_middle = load.point - middle_of(contact, arm);
    load.couple = rate * contact.couple_about(from_middle) * contact.normal;
  }
  return load;
}

template <int D>
bool RigidContacts<D>::is_consistent() const {
  const auto is_valid = [&](const RigidContact<D>& at) {
    const auto is_rigid = [&](std::int32_t block) {
      return block >= 0 && std::size_t(block) < blocks_.slot_count() && blocks_.lives(std::size_t(block)) &&
             !blocks_.is_deformable(std::size_t(block));
    };
    if constexpr (D == 3) {
      if (!is_nonnegative(at.manifold.area)) return false;
    }
    return is_rigid(at.a) && is_rigid(at.b) &&
           names_features(at.manifold, blocks_.own_outline(at.a), blocks_.own_outline(at.b)) &&
           halfspace::all(at.manifold.point, [](const Vector<D>& point) { return point.allFinite(); }) &&
           halfspace::all(at.impulse, is_nonnegative) && at.friction.allFinite() && is_finite(at.couple) &&
           at.found_to_b.allFinite() && halfspace::all(at.gap, is_finite) && at.normal.allFinite() &&
           is_finite(at.touched_at) && is_finite(at.impact_loss);
  };
  return touches_ >= 0 && iterations_ >= 0 && is_nonnegative(unbalanced_velocity_) &&
         pauses_.size() <= blocks_.slot_count() &&
         halfspace::all(pauses_, [](const SolverPause& pause) { return pause.is_consistent(); }) &&
         rest_.is_consistent() && is_nonnegative(duration_) && halfspace::all(known_, is_valid) &&
         std::is_sorted(known_.begin(), known_.end(), is_before<D>);
}

template class RigidContacts<2>;
template class RigidContacts<3>;

}  // namespace halfspace
