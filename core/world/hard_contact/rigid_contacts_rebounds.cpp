// Rebounds of rigid blocks: in a motion that has any, the velocity problem is one of the whole impulses.

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/tolerances.h"
#include "world/hard_contact/rigid_contacts.h"

namespace halfspace {
namespace {

/// Trials of the times of impact, and of both these and restitution.
constexpr int max_matches = 3, max_trials = 9;

/// Moves a row from where blocks are now to where they were between the start of the motion and now.
template <int D>
void move_row(ImpulseRow<D>& row, const ImpulseRow<D>& at_start, double part) {
  row.direction = (1 - part) * at_start.direction + part * row.direction;
  row.turn_a = (1 - part) * at_start.turn_a + part * row.turn_a;
  row.turn_b = (1 - part) * at_start.turn_b + part * row.turn_b;
}

/// The row along a direction, of rows along others.
template <int D>
ImpulseRow<D> row_along(const Vector<D>& direction, std::span<const ImpulseRow<D>> rows) {
  ImpulseRow<D> along = rows.front();
  along.direction.setZero();
  along.turn_a.setZero();
  along.turn_b.setZero();
  for (const ImpulseRow<D>& row : rows) {
    const double part = direction.dot(row.direction);
    along.direction += part * row.direction;
    along.turn_a += part * row.turn_a;
    along.turn_b += part * row.turn_b;
  }
  return along;
}

}  // namespace

/// The impulses of the first half step make the end of a path that bounces off, and would turn blocks by arms
/// that are not those of the touch. So a motion with rebounds takes them back, and finds the whole impulses
/// (Moreau 1988) from the velocities without any.
template <int D>
void RigidContacts<D>::keep_first_impulses() {
  first_.contacts.clear();
  if (std::none_of(predicted_.begin(), predicted_.end(),
                   [](const PredictedContact<D>& contact) { return contact.rebounds(); }))
    return;
  rebound_trials_ = 0;
  first_.contacts.assign(problem_.contacts.begin(), problem_.contacts.end());
  first_.rows.assign(problem_.rows.begin(), problem_.rows.end());
}

/// The whole impulses of a contact act where its blocks were at the time of impact: angular momentum is kept
/// when they and those of the first half step move blocks alike from then on. Where blocks rest, that is half
/// of the motion. The couple of friction acts anywhere. Inertias are those of now. Slip is not followed.
template <int D>
void RigidContacts<D>::take_first_rows() {
  for (std::size_t c = 0; c < predicted_.size(); ++c) {
    const ImpulseContact<D>&contact = problem_.contacts[c], &first = first_.contacts[c];
    const InverseMass<D>&a = problem_.inverse_masses[std::size_t(contact.a)],
          &b = problem_.inverse_masses[std::size_t(contact.b)];
    for (ImpulseRow<D>& row : first_.rows_of(first)) row.set_masses(a, b);
    auto at_start = first_.normals_of(first).begin();
    for (ImpulseRow<D>& row : problem_.normals_of(contact)) {
      move_row(row, *at_start++, predicted_[c].impact_at);
      row.set_masses(a, b);
    }
    if (contact.friction_count == 0) continue;
    const std::span<const ImpulseRow<D>> tangents = first_.frictions_of(first).first(D - 1);
    for (std::size_t k = 0; k < D - 1; ++k) {
      ImpulseRow<D>& row = problem_.frictions_of(contact)[k];
      move_row(row, row_along<D>(row.direction, tangents), predicted_[c].friction_at[k]);
      row.set_masses(a, b);
    }
  }
  for (ImpulseRow<D>& row : problem_.rows) {
    row.slip = row.target = 0;
    row.impulse *= 2;  // where blocks rest, those of the first half step are half of the whole ones
  }
}

template <int D>
void RigidContacts<D>::take_back_first_impulses() {
  for (const ImpulseContact<D>& first : first_.contacts) {
    for (const ImpulseRow<D>& row : first_.rows_of(first)) problem_.apply(first, row, -row.impulse);
  }
}

/// By the velocities of approach along the rows that the impulses act along: else these could make energy.
template <int D>
void RigidContacts<D>::set_rebounds() {
  for (std::size_t c = 0; c < predicted_.size(); ++c) {
    PredictedContact<D>& contact = predicted_[c];
    const ImpulseContact<D>& of = problem_.contacts[c];
    const double restitution = model_.law_between(std::size_t(contact.a), std::size_t(contact.b)).restitution;
    std::size_t i = 0;
    for (const ImpulseRow<D>& row : problem_.normals_of(of)) {
      if (contact.rebound[i] > 0)
        contact.rebound[i] = restitution * (contact.gained[i] - problem_.velocity_along(of, row));
      ++i;
    }
  }
}

/// Finds the times of impact from the impulses of the first half step and the whole ones. True if one of a
/// rebound has changed.
template <int D>
bool RigidContacts<D>::match_times_of_impact() {
  bool has_changed = false;
  for (std::size_t c = 0; c < predicted_.size(); ++c) {
    PredictedContact<D>& contact = predicted_[c];
    const ImpulseContact<D>&of = problem_.contacts[c], &of_first = first_.contacts[c];
    const auto match = [&](double& at, double first, double whole) {
      const double before = std::exchange(at, std::clamp(1 - first / whole, 0.0, 1.0));
      has_changed |= contact.rebounds() && std::abs(at - before) > matched_time;
    };
    const double whole = problem_.normal_impulse(of);
    if (!(whole > 0)) continue;
    match(contact.impact_at, first_.normal_impulse(of_first), whole);
    if (of.friction_count == 0) continue;
    const Vector<D> friction = first_.friction_impulse(of_first);
    for (std::size_t k = 0; k < D - 1; ++k) {
      const ImpulseRow<D>& row = problem_.frictions_of(of)[k];
      if (row.impulse != 0) match(contact.friction_at[k], friction.dot(row.direction), row.impulse);
    }
  }
  return has_changed;
}

/// In the half step, by the velocities before its impulses and after them.
template <int D>
ImpulseWork RigidContacts<D>::work_of(std::size_t c) const {
  const ImpulseContact<D>& contact = problem_.contacts[c];
  const std::size_t a = std::size_t(contact.a), b = std::size_t(contact.b);
  const BlockMotion<D> motion_a = motion(a), motion_b = motion(b);
  const BlockMotion<D> change_a = changes().of_motion(a), change_b = changes().of_motion(b);
  const auto prescribed = [&](std::size_t i, const BlockMotion<D>& motion) {
    return blocks_.kind[i] == BlockKind::prescribed ? motion : BlockMotion<D>{};
  };
  const BlockMotion<D> given_a = prescribed(a, motion_a), given_b = prescribed(b, motion_b);
  ImpulseWork work;
  for_each_impulse(c, [&](const ImpulseRow<D>& row, double impulse, bool is_normal) {
    const double velocity = row.velocity(motion_a, motion_b), change = 0.5 * row.velocity(change_a, change_b);
    (is_normal ? work.normal : work.friction) += impulse * (velocity + change);
    work.outer -= impulse * row.velocity(given_a, given_b);
    work.size += std::abs(impulse) * (std::abs(velocity) + std::abs(change));
  });
  return work;
}

template <int D>
void RigidContacts<D>::sum_work_of_islands() {
  work_of_islands_.assign(problem_.islands.count(), {});
  for (std::size_t c = 0; c < predicted_.size(); ++c) {
    ImpulseWork& island = work_of_islands_[problem_.islands.of_contact(c)];
    island.add(predicted_[c].work);
    island.add(work_of(c));
  }
}

template <int D>
bool RigidContacts<D>::improve_rebounds() {
  if (!solves_whole() || rebound_trials_ > max_trials) return false;
  if (rebound_trials_ < max_matches && match_times_of_impact()) {
    ++rebound_trials_;
    set_velocity_targets();
    return true;
  }
  rebound_trials_ = std::max(rebound_trials_, max_matches);
  return lower_rebounds();
}

/// Where friction makes a contact gain energy, and where simultaneous impacts of connected blocks gain some
/// together, as those of a block between two others do.
template <int D>
bool RigidContacts<D>::lower_rebounds() {
  sum_work_of_islands();
  bool has_changed = false;
  for (std::size_t c = 0; c < predicted_.size(); ++c) {
    if (!predicted_[c].rebounds()) continue;
    ImpulseWork own = predicted_[c].work;
    own.add(work_of(c));
    const ImpulseWork& island = work_of_islands_[problem_.islands.of_contact(c)];
    const bool gains_by_friction = own.friction > 0 && own.normal <= 0;
    const ImpulseWork& worse = gains_by_friction && own.ratio() > island.ratio() ? own : island;
    has_changed |= predicted_[c].fraction.improve(worse.sum(), worse.size);
  }
  if (!has_changed) return false;
  if (++rebound_trials_ > max_trials) {
    for (PredictedContact<D>& contact : predicted_) contact.fraction.settle();
  }
  set_motions(Half::second);
  set_targets();
  return true;
}

#define HALFSPACE_MEMBERS(D)                                         \
  template void RigidContacts<D>::keep_first_impulses();             \
  template void RigidContacts<D>::take_first_rows();                 \
  template void RigidContacts<D>::take_back_first_impulses();        \
  template void RigidContacts<D>::set_rebounds();                    \
  template bool RigidContacts<D>::match_times_of_impact();           \
  template ImpulseWork RigidContacts<D>::work_of(std::size_t) const; \
  template void RigidContacts<D>::sum_work_of_islands();             \
  template bool RigidContacts<D>::improve_rebounds();                \
  template bool RigidContacts<D>::lower_rebounds();
HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
