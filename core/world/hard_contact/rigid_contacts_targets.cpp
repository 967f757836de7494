// What impulses of rigid blocks have to reach: gaps that stay open, places that stick, velocities after
// impacts.

#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"
#include "world/hard_contact/limits.h"
#include "world/hard_contact/rigid_contacts.h"

namespace halfspace {

/// Blocks that others support do not fall: adds the impulses at points and those of the last motion, but no
/// more than hold a block, since those of an impact would lift it.
template <int D>
void RigidContacts<D>::add_support() {
  const auto falling = [&](std::size_t i) {
    BlockMotion<D> motion = free_motions_[i];
    if (model_.may_have_points()) motion += changes().of_motion(i);
    return motion;
  };
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i) problem_.motions[i] = falling(i);
  for (const ImpulseContact<D>& contact : problem_.contacts) {
    for (const ImpulseRow<D>& row : problem_.rows_of(contact)) problem_.apply(contact, row, row.impulse);
  }
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i) {
    const BlockMotion<D> free = falling(i), support = problem_.motions[i] - free;
    const Vector<D> fall = free.velocity - problem_.start[i].velocity;
    const double opposed = -support.velocity.dot(fall);
    const double part = opposed > 0 ? std::min(1.0, fall.squaredNorm() / opposed) : 0;
    problem_.motions[i] = {free.velocity + part * support.velocity, free.spin + part * support.spin};
  }
}

/// An impact reverses the velocity of approach at its time within the step, and the rest of the step is free
/// flight: for blocks under constant forces that is exact. Points that bore in the last motion, or were on a
/// face that did, are at rest unless they approach faster than gravity and the solver's tolerance let them.
template <int D>
void RigidContacts<D>::find_impacts(double time, double duration) {
  free_motions_.assign(problem_.motions.begin(), problem_.motions.end());
  add_support();
  const double slow = duration * model_.settings.gravity.norm() + unbalanced_velocity_;
  std::size_t c = 0;
  for (PredictedContact<D>& contact : predicted_) {
    ImpulseContact<D>& of = problem_.contacts[c++];
    const std::span<ImpulseRow<D>> rows = problem_.normals_of(of);
    const double restitution = model_.law_between(std::size_t(contact.a), std::size_t(contact.b)).restitution;
    const BlockMotion<D> a = motion(std::size_t(of.a)), b = motion(std::size_t(of.b));
    const bool bears = contact.normal_impulse() > 0;
    double first = HUGE_VAL;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double opening = rows[i].velocity(a, b);
      const bool rests = bears && (rows[i].impulse > 0 || contact.gap[i] <= search_.reach(contact));
      if (rests && opening >= -slow) continue;
      const double acceleration = 2 / duration * (problem_.velocity_along(of, rows[i]) - opening);
      const double gap = std::max(0.0, contact.gap[i]);
      const double end = gap + duration * (opening + 0.5 * acceleration * duration);
      const double square = opening * opening - 2 * acceleration * gap;
      const bool is_approached = gap > 0 || opening < -equal_within * std::abs(acceleration) * duration;
      if (!(end < search_.reach(contact)) || !is_approached || !(square > 0)) continue;
      const double speed = std::sqrt(square);
      const double at = std::clamp(2 * gap / (speed - opening), 0.0, duration);
      const double rest = duration - at;
      if (at > end_reach * duration)
        fraction_before_impact_ = std::min(fraction_before_impact_, at / duration);
      first = std::min(first, at);
      if (restitution == 0 || !(restitution * speed + acceleration * rest > 0)) continue;
      contact.rebound[i] = restitution * speed;
      contact.gained[i] = acceleration * rest;
      contact.rebound_gap[i] = std::max(0.0, rest * (restitution * speed + 0.5 * acceleration * rest));
    }
    contact.impact_at = first < duration ? first / duration : 0.5;
    contact.friction_at.fill(contact.impact_at);
    if (contact.is_new) contact.touched_at = time + std::min(first, duration);
  }
  std::copy(free_motions_.begin(), free_motions_.end(), problem_.motions.begin());
}

/// Penetration stays as it is: the points of a jammed heap could not all recover in one solve, so that their
/// impulses would grow without end. A loaded point near its face keeps its gap, too: where blocks have more
/// such points than they can move, those of an iteration that did not converge could not all close.
template <int D>
double RigidContacts<D>::gap_floor(const PredictedContact<D>& contact, std::size_t point) const {
  const double gap = contact.gap[point];
  if (contact.rebound_gap[point] > 0) return std::min(gap, 0.0) + contact.rebound_gap[point];
  return contact.was_loaded[point] && gap <= search_.resting_gap(contact) ? gap : std::min(gap, 0.0);
}

template <int D>
void RigidContacts<D>::set_gap_targets(double duration) {
  for (std::size_t c = 0; c < predicted_.size(); ++c) {
    const PredictedContact<D>& contact = predicted_[c];
    const auto predicted = search_.predicted_gaps(contact);
    const std::span<ImpulseRow<D>> rows = problem_.normals_of(problem_.contacts[c]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double free = problem_.velocity_along(problem_.contacts[c], rows[i]);
      const double end = contact.rebound_gap[i] > 0 ? contact.gap[i] + duration * free : predicted[i];
      rows[i].target = free - (end - gap_floor(contact, i)) / duration;
    }
  }
  set_slip_targets(duration);
}

template <int D>
bool RigidContacts<D>::turns(std::int32_t mover) const {
  const std::size_t i = std::size_t(mover);
  return can_move(i) && integrator_.predicted_rotation(i).farthest_from(blocks_.rotation[i]) > no_turn;
}

/// Friction that sticks keeps two points together to the motion's end. The linear rows leave out that their
/// arms turn: a block would creep outwards on a platform that turns. Where nothing turns this is not seen.
template <int D>
void RigidContacts<D>::set_slip_targets(double duration) {
  for (std::size_t c = 0; c < predicted_.size(); ++c) {
    const ImpulseContact<D>& of = problem_.contacts[c];
    if (of.friction_count == 0 || !(turns(of.a) || turns(of.b))) continue;
    const Vector<D> way = search_.predicted_slip(predicted_[c]);
    for (ImpulseRow<D>& row : problem_.frictions_of(of)) {
      if (!row.direction.isZero(0))
        row.target = problem_.velocity_along(of, row) - row.direction.dot(way) / duration;
    }
  }
}

/// Gaps also change as their normals turn, which the linear rows leave out. True when the change since the
/// last solution is below the tolerance.
template <int D>
bool RigidContacts<D>::correct_targets(double duration) {
  bool is_accurate = true;
  for (std::size_t c = 0; c < predicted_.size(); ++c) {
    const PredictedContact<D>& contact = predicted_[c];
    const auto predicted = search_.predicted_gaps(contact);
    const std::span<ImpulseRow<D>> rows = problem_.normals_of(problem_.contacts[c]);
    const double tolerance = solved_within * search_.reach(contact);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double penetrated = predicted[i] - std::min(contact.gap[i], 0.0);
      if (contact.rebound_gap[i] > 0 && penetrated >= 0) continue;
      const double excess = contact.rebound_gap[i] > 0 ? penetrated : predicted[i] - gap_floor(contact, i);
      const double error =
          excess / duration - (problem_.velocity_along(problem_.contacts[c], rows[i]) - rows[i].target);
      rows[i].target -= error;
      const bool is_active = rows[i].impulse > 0 || excess < 0;
      if (is_active && !(duration * std::abs(error) <= tolerance)) is_accurate = false;
    }
  }
  set_slip_targets(duration);
  return is_accurate;
}

template <int D>
void RigidContacts<D>::set_velocity_targets() {
  if (predicted_.empty()) return;
  set_start(Half::second);
  rows_.build(predicted_, problem_);
  if (solves_whole()) take_first_rows();
  set_motions(Half::second);
  if (solves_whole()) set_rebounds();
  set_targets();
}

/// Points that neither bear nor are on their face have no target.
template <int D>
void RigidContacts<D>::set_targets() {
  for (std::size_t c = 0; c < predicted_.size(); ++c) {
    const PredictedContact<D>& contact = predicted_[c];
    const std::span<ImpulseRow<D>> rows = problem_.normals_of(problem_.contacts[c]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const bool touches = rows[i].impulse > 0 || contact.gap[i] <= search_.reach(contact);
      const double opening =
          contact.rebound[i] > 0 ? contact.fraction.value() * contact.rebound[i] + contact.gained[i] : 0;
      rows[i].target = touches || contact.rebound[i] > 0 ? std::max(0.0, opening) : -HUGE_VAL;
    }
  }
}

#define HALFSPACE_MEMBERS(D)                                                                  \
  template void RigidContacts<D>::add_support();                                              \
  template void RigidContacts<D>::find_impacts(double, double);                               \
  template double RigidContacts<D>::gap_floor(const PredictedContact<D>&, std::size_t) const; \
  template void RigidContacts<D>::set_gap_targets(double);                                    \
  template bool RigidContacts<D>::turns(std::int32_t) const;                                  \
  template void RigidContacts<D>::set_slip_targets(double);                                   \
  template bool RigidContacts<D>::correct_targets(double);                                    \
  template void RigidContacts<D>::set_velocity_targets();                                     \
  template void RigidContacts<D>::set_targets();
HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
