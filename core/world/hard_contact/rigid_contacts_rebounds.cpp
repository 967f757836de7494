// Rebounds of rigid blocks: in a motion that has any, the velocity problem is one of the whole impulses.

#include <algorithm>
#include <cmath>

#include "world/hard_contact/rigid_contacts.h"

namespace halfspace {
namespace {

constexpr int max_rebound_trials = 6;

template <int D>
std::int32_t free_block_of(const ImpulseContact<D>& contact) {
  return contact.inverse_mass_a > 0 ? contact.a : contact.b;
}

}  // namespace

/// The impulses of the first half step make the end of a path that bounces off, and would turn blocks by arms
/// that are not those of the touch. So a motion with rebounds takes them back, and finds the whole impulses
/// (Moreau 1988) from the velocities without any.
template <int D>
void RigidContacts<D>::keep_first_impulses() {
  first_.contacts.clear();
  if (std::none_of(planned_.begin(), planned_.end(),
                   [](const PlannedContact<D>& contact) { return contact.rebounds(); }))
    return;
  rebound_trials_ = 0;
  first_.contacts.assign(problem_.contacts.begin(), problem_.contacts.end());
  first_.rows.assign(problem_.rows.begin(), problem_.rows.end());
}

/// An early impact has the arms of the motion's start. Inertias are those of now. Slip is not followed. Where
/// blocks rest, the whole impulses are twice those of the first half step.
template <int D>
void RigidContacts<D>::take_first_rows() {
  for (std::size_t c = 0; c < planned_.size(); ++c) {
    const ImpulseContact<D>& contact = problem_.contacts[c];
    const InverseMass<D>&a = problem_.inverse_masses[std::size_t(contact.a)],
          &b = problem_.inverse_masses[std::size_t(contact.b)];
    const ImpulseContact<D>& first = first_.contacts[c];
    for (std::int32_t i = 0; i < first.normal_count + first.friction_count; ++i) {
      first_.rows[std::size_t(first.first_row + i)].set_masses(a, b);
    }
    const bool is_alike =
        first.normal_count == contact.normal_count && first.friction_count == contact.friction_count;
    if (planned_[c].rebounds() && planned_[c].is_early && is_alike) {
      const auto rows = first_.rows_of(first);
      std::copy(rows.begin(), rows.end(), problem_.rows.begin() + contact.first_row);
    }
  }
  for (ImpulseRow<D>& row : problem_.rows) {
    row.slip = row.target = 0;
    row.impulse *= 2;
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
  for (std::size_t c = 0; c < planned_.size(); ++c) {
    PlannedContact<D>& contact = planned_[c];
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
  islands_.begin(blocks_.slot_count());
  for (const ImpulseContact<D>& contact : problem_.contacts) {
    if (contact.inverse_mass_a > 0 && contact.inverse_mass_b > 0) islands_.join(contact.a, contact.b);
  }
  for (std::size_t c = 0; c < planned_.size(); ++c) {
    ImpulseWork& island = islands_.of(free_block_of(problem_.contacts[c]));
    island.add(planned_[c].work);
    island.add(work_of(c));
  }
}

/// Where friction makes a contact gain energy, and where simultaneous impacts of connected blocks gain some
/// together, as those of a block between two others do.
template <int D>
bool RigidContacts<D>::lower_rebounds() {
  if (!solves_whole() || rebound_trials_ > max_rebound_trials) return false;
  sum_work_of_islands();
  bool has_changed = false;
  for (std::size_t c = 0; c < planned_.size(); ++c) {
    if (!planned_[c].rebounds()) continue;
    ImpulseWork own = planned_[c].work;
    own.add(work_of(c));
    const ImpulseWork& island = islands_.of(free_block_of(problem_.contacts[c]));
    const bool gains_by_friction = own.friction > 0 && own.normal <= 0;
    const ImpulseWork& worse = gains_by_friction && own.ratio() > island.ratio() ? own : island;
    has_changed |= planned_[c].fraction.improve(worse.sum(), worse.size);
  }
  if (!has_changed) return false;
  if (++rebound_trials_ > max_rebound_trials) {
    for (PlannedContact<D>& contact : planned_) contact.fraction.settle();
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
  template ImpulseWork RigidContacts<D>::work_of(std::size_t) const; \
  template void RigidContacts<D>::sum_work_of_islands();             \
  template bool RigidContacts<D>::lower_rebounds();
HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
