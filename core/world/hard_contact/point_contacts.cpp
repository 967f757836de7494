#include "world/hard_contact/point_contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/tolerances.h"
#include "world/hard_contact/accelerated_sweeps.h"
#include "world/hard_contact/limits.h"

namespace halfspace {
namespace {

template <int D>
bool precedes(const PointContact<D>& one, const PointContact<D>& other) {
  return one.key() < other.key();
}

}  // namespace

template <int D>
void PointContacts<D>::push(double scale) {
  for (const ContactConstraint<D>& at : predicted_) {
    changes().add(at.of_a, scale * at.impulse);
    changes().add(at.of_b, -scale * at.impulse);
  }
}

template <int D>
Vector<D> PointContacts<D>::kicked(const ContactConstraint<D>& at) const {
  return changes().at(at.of_a) - changes().at(at.of_b);
}

/// Persistent contacts keep their gap while they are on their faces: more of them than a block has degrees of
/// freedom never agree on a gap of zero.
template <int D>
double PointContacts<D>::gap_floor_of(const ContactConstraint<D>& at) const {
  const std::size_t b = std::size_t(at.b);
  const double settled = at.is_persistent ? search_.reach(b) : 0;
  if (std::abs(at.gap) < settled) return at.gap;
  return std::min(-settled, at.gap + recovered_way * blocks_.radius[b]);
}

/// The velocity that a constraint acts on is that of the predicted motion without impulses.
template <int D>
void PointContacts<D>::begin(ContactConstraint<D>& at, double duration) const {
  const ContactLaw& law = model_.law_between(std::size_t(at.a), std::size_t(at.b));
  at.tan_friction = law.tan_friction;
  at.gap_floor = gap_floor_of(at);
  if (at.is_bonded) {
    at.gap_floor = at.gap;
    at.tension_limit = 0.5 * duration * law.tensile_strength * at.area;
    at.cohesion_limit = 0.5 * duration * law.cohesion * at.area;
  }
  const Vector<D> kicked = this->kicked(at);
  const Vector<D> free =
      integrator_.predicted_velocity(at.of_a) - integrator_.predicted_velocity(at.of_b) - kicked;
  const double opening = (search_.predicted_gap(at) - at.gap_floor) / duration - at.normal.dot(kicked);
  at.velocity = opening * at.normal + (1 - at.impact_fraction) * (free - free.dot(at.normal) * at.normal);
}

template <int D>
bool PointContacts<D>::find_more(double time, double duration) {
  search_.find(found_);
  std::erase_if(found_, [&](const ContactConstraint<D>& at) {
    return std::binary_search(predicted_.begin(), predicted_.end(), at, precedes<D>);
  });
  if (found_.empty()) return false;
  remember(found_, time, duration);
  for (ContactConstraint<D>& at : found_) {
    begin(at, duration);
    at.impulse = Vector<D>::Zero();
  }
  predicted_.insert(predicted_.end(), found_.begin(), found_.end());
  std::sort(predicted_.begin(), predicted_.end(), precedes<D>);
  return true;
}

template <int D>
void PointContacts<D>::find(double time, double duration) {
  motion_began_ = time;
  search_.find(predicted_);
  remember(predicted_, time, duration);
  for (ContactConstraint<D>& at : predicted_) begin(at, duration);
}

template <int D>
void PointContacts<D>::solve() {
  if (empty()) return;
  PointRows<D> rows(predicted_, changes());
  next_iterations_ += balance(rows, rows.begin(), max_sweeps_of_points).iterations;
}

template <int D>
bool PointContacts<D>::correct(double duration) {
  bool is_exact = true;
  for (ContactConstraint<D>& at : predicted_) {
    at.gap = search_.predicted_gap(at);
    const double error = at.gap - at.gap_floor - duration * at.normal.dot(at.velocity + kicked(at));
    at.velocity += error / duration * at.normal;
    const bool is_active = at.is_bonded || !at.impulse.isZero(0) || at.gap < at.gap_floor;
    if (is_active && !(std::abs(error) <= solved_within * search_.reach(std::size_t(at.b)))) is_exact = false;
  }
  return is_exact;
}

/// Persistent contacts keep their time of first touch. Those present when a block's first step begins are
/// bonded, as with springs (Wang et al. 2021, section 2.5).
template <int D>
void PointContacts<D>::remember(Array<ContactConstraint<D>>& found, double time, double duration) const {
  auto before = known_.begin();
  for (ContactConstraint<D>& at : found) {
    while (before != known_.end() && before->key() < at.key()) ++before;
    const bool is_persistent = before != known_.end() && before->key() == at.key();
    at.touched_at = is_persistent ? before->touched_at : time + at.impact_fraction * duration;
    if (is_persistent) {
      at.impact_fraction = 0;
      at.is_persistent = true;
      at.impulse = before->impulse;
      at.is_bonded = before->is_bonded;
      at.area = before->area;
      at.stored_normal_work = before->stored_normal_work;
    } else if (contacts_.bonds(at.a, at.b)) {
      at.area = search_.area_of(at);
      at.is_bonded = at.area > 0;
    }
  }
}

/// The work of a contact's normal impulse at this velocity before it.
template <int D>
double PointContacts<D>::normal_work(const ContactConstraint<D>& at, const Vector<D>& velocity) const {
  return at.impulse.dot(at.normal) * at.normal.dot(velocity + 0.5 * kicked(at));
}

/// Adds the work of an impulse to the ledger. Returns that of its normal part.
template <int D>
double PointContacts<D>::book(const ContactConstraint<D>& at, const Vector<D>& velocity,
                              EnergyLedger& ledger) const {
  const double normal_work = this->normal_work(at, velocity);
  ledger.add_impact_loss(-normal_work);
  ledger.add_friction_loss(normal_work - at.impulse.dot(velocity + 0.5 * kicked(at)));
  ledger.add_outer_work(
      -at.impulse.dot(prescribed_velocity_of(at.of_a, blocks_) - prescribed_velocity_of(at.of_b, blocks_)));
  return normal_work;
}

template <int D>
Vector<D> PointContacts<D>::velocity_of(const ContactConstraint<D>& at) const {
  return halfspace::velocity_of(at.of_a, blocks_) - halfspace::velocity_of(at.of_b, blocks_);
}

/// Impulses act before all other forces at a motion's start and after them at its end, so that the step
/// itself conserves energy: a body that falls onto a floor loses what it has on arrival.
template <int D>
void PointContacts<D>::apply_position_impulses(EnergyLedger& ledger) {
  const double half = 0.5 * integrator_.duration();
  for (ContactConstraint<D>& at : predicted_) {
    at.applied_velocity_change =
        half * (integrator_.acceleration_of(at.of_a) - integrator_.acceleration_of(at.of_b));
    const double normal_work = book(at, velocity_of(at), ledger);
    const bool is_new = at.touched_at >= motion_began_;
    const bool lies_there = is_new && known_.empty() && !is_approached(at);
    at.is_new_impact = is_new && !lies_there;
    // A contact that is there from the start carries its load from the start.
    if (lies_there) at.stored_normal_work = normal_work;
  }
}

template <int D>
bool PointContacts<D>::is_approached(const ContactConstraint<D>& at) const {
  return at.impact_fraction > 0 ||
         at.normal.dot(velocity_of(at)) < -equal_within * at.applied_velocity_change.norm();
}

template <int D>
void PointContacts<D>::break_when_due(ContactConstraint<D>& at) const {
  if (!at.is_bonded || !at.fails(at.velocity + kicked(at))) return;
  at.is_bonded = 0;
  at.area = at.tension_limit = at.cohesion_limit = 0;
}

template <int D>
void PointContacts<D>::find_at_end() {
  std::erase_if(predicted_, [&](const ContactConstraint<D>& at) {
    return !at.is_bonded && at.impulse.isZero(0) && at.gap > search_.reach(std::size_t(at.b));
  });
  for (ContactConstraint<D>& at : predicted_) {
    break_when_due(at);
    search_.place(at);
    if (at.gap < -converged_gap * blocks_.radius[std::size_t(at.b)])
      deepest_ = std::max(deepest_, -at.gap / blocks_.thinner(at.a, at.b));
    at.approach_velocity = velocity_of(at) + at.applied_velocity_change;
  }
}

/// Has any contact closed in this motion?
template <int D>
bool PointContacts<D>::is_impact() const {
  return std::any_of(predicted_.begin(), predicted_.end(),
                     [](const ContactConstraint<D>& at) { return at.is_new_impact; });
}

template <int D>
bool PointContacts<D>::begin_impact(bool is_other_impact) {
  is_impact_ = !predicted_.empty() && (is_other_impact || is_impact());
  if (!is_impact_) return false;
  for (ContactConstraint<D>& at : predicted_) at.velocity = at.approach_velocity;
  return true;
}

template <int D>
void PointContacts<D>::end_impact() {
  for (ContactConstraint<D>& at : predicted_) at.impact_loss = -normal_work(at, at.approach_velocity);
}

/// Loaded contacts store energy in each second half step and release it in the first of the next motion. That
/// is no loss.
template <int D>
void PointContacts<D>::book_velocity_impulses(EnergyLedger& ledger) {
  for (ContactConstraint<D>& at : predicted_) {
    const double normal_work = book(at, at.velocity, ledger);
    const double stored_normal_work = is_impact_
                                          ? -normal_work - at.impact_loss
                                          : 0.5 * at.impulse.dot(at.normal) * at.normal.dot(kicked(at));
    ledger.add_impact_loss(at.stored_normal_work - stored_normal_work);
    at.stored_normal_work = stored_normal_work;
  }
}

template <int D>
void PointContacts<D>::set_velocities() {
  for (ContactConstraint<D>& at : predicted_) at.velocity = velocity_of(at);
}

template <int D>
void PointContacts<D>::end_motion(EnergyLedger& ledger) {
  book_velocity_impulses(ledger);
  for (ContactConstraint<D>& at : predicted_) break_when_due(at);
  const double rate = changes().rate();
  for (ContactConstraint<D>& at : predicted_) at.force = rate * at.impulse;
  iterations_ += std::exchange(next_iterations_, 0);
  exchange_known(ledger);
}

template <int D>
void PointContacts<D>::exchange_known(EnergyLedger& ledger) {
  auto before = known_.begin();
  for (const ContactConstraint<D>& at : predicted_) {
    for (; before != known_.end() && before->key() < at.key(); ++before)
      ledger.add_impact_loss(before->stored_normal_work);
    if (before != known_.end() && before->key() == at.key()) {
      ++before;
    } else {
      ++touches_;
    }
  }
  for (; before != known_.end(); ++before) ledger.add_impact_loss(before->stored_normal_work);
  next_known_.assign(predicted_.begin(), predicted_.end());
  known_.swap(next_known_);
  predicted_.clear();
}

template <int D>
void PointContacts<D>::note_pressed(PressedPair& pair) const {
  if (predicted_.empty()) {
    for (const PointContact<D>& at : known_) pair.note(at.a, at.b, at.force.norm());
  } else {
    for (const ContactConstraint<D>& at : predicted_)
      pair.note(at.a, at.b, changes().rate() * at.impulse.norm());
  }
}

template <int D>
bool PointContacts<D>::is_consistent() const {
  const auto is_carried = [&](const MaterialPoint<D>& point, std::int32_t block) {
    if (point.block != block || block < 0 || std::size_t(block) >= blocks_.slot_count()) return false;
    if (!blocks_.lives(std::size_t(block)) || !point.weight.allFinite() || !point.arm.allFinite())
      return false;
    return !blocks_.is_of_mesh(std::size_t(block)) || halfspace::all(point.node, [&](std::int32_t node) {
      return node >= 0 && std::size_t(node) < blocks_.meshes().node_count();
    });
  };
  const auto is_valid = [&](const PointContact<D>& at) {
    return is_carried(at.of_a, at.a) && is_carried(at.of_b, at.b) && at.feature_a >= 0 && at.feature_b >= 0 &&
           (at.meeting == Meeting::corner_and_face || (D == 3 && at.meeting == Meeting::edges)) &&
           at.normal.allFinite() && at.impulse.allFinite() && at.force.allFinite() && is_finite(at.gap) &&
           is_finite(at.stored_normal_work) && is_finite(at.impact_loss) && is_finite(at.touched_at) &&
           is_nonnegative(at.area);
  };
  return touches_ >= 0 && iterations_ >= 0 && halfspace::all(known_, is_valid) &&
         std::is_sorted(known_.begin(), known_.end(), precedes<D>);
}

template class PointContacts<2>;
template class PointContacts<3>;

}  // namespace halfspace
