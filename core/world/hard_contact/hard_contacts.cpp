#include "world/hard_contact/hard_contacts.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// Ends of motions are exact to this share of what lies at a face.
constexpr double exact_share = 0.1;
constexpr int most_corrections = 4;

/// Two that lie in each other at the start of a motion come apart by this share of the block.
constexpr double recovered_share = 1e-7;

constexpr int most_searches = 4;

/// The depth, as a share of a block's radius, that rounding and turns do not reach: there rounds have not
/// sufficed.
constexpr double told_depth = 1e-3;

template <int D>
bool precedes(const ContactConstraint<D>& one, const ContactConstraint<D>& other) {
  return one.key() < other.key();
}

}  // namespace

template <int D>
void HardContacts<D>::solve(double duration) {
  integrator_.kicks().begin(duration);
  iterations_ += solve_constraints<D>(planned_, integrator_.kicks());
}

template <int D>
Vector<D> HardContacts<D>::kicked(const ContactConstraint<D>& at) const {
  return integrator_.kicks().at(at.of_a) - integrator_.kicks().at(at.of_b);
}

/// Contacts that go on stay as they are as long as they lie at their faces: more of them than a block has
/// ways to move never quite agree on a gap of zero.
template <int D>
double HardContacts<D>::gap_floor_of(const ContactConstraint<D>& at) const {
  const std::size_t b = std::size_t(at.b);
  const double settled = at.is_persistent ? search_.reach(b) : 0;
  if (std::abs(at.gap) < settled) return at.gap;
  return std::min(-settled, at.gap + recovered_share * blocks_.radius[b]);
}

/// The velocity that a contact has to stop is that of the planned motion without any kicks.
template <int D>
void HardContacts<D>::begin(ContactConstraint<D>& at, double duration) const {
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

/// Kicks may lead to where nothing has been seen to meet: then it is looked for anew. False when all that
/// meets is known.
template <int D>
bool HardContacts<D>::find_more(double time, double duration) {
  search_.find(found_);
  std::erase_if(found_, [&](const ContactConstraint<D>& at) {
    return std::binary_search(planned_.begin(), planned_.end(), at, precedes<D>);
  });
  if (found_.empty()) return false;
  remember(found_, time, duration);
  for (ContactConstraint<D>& at : found_) {
    begin(at, duration);
    at.impulse = Vector<D>::Zero();
  }
  planned_.insert(planned_.end(), found_.begin(), found_.end());
  std::sort(planned_.begin(), planned_.end(), precedes<D>);
  return true;
}

template <int D>
bool HardContacts<D>::predict(double time, double duration) {
  motion_began_ = time;
  search_.find(planned_);
  if (planned_.empty()) return true;
  remember(planned_, time, duration);
  for (ContactConstraint<D>& at : planned_) begin(at, duration);
  int searches = 1;
  do {
    bool is_exact = false;
    for (int i = 0; i < most_corrections && !is_exact; ++i) {
      solve(duration);
      if (!integrator_.predict(duration)) return false;
      is_exact = correct(duration);
    }
  } while (searches++ < most_searches && find_more(time, duration));
  return true;
}

/// Gaps open as their normals turn, too, which impulses have not been told: it is made up for. True when it
/// has been too little to count.
template <int D>
bool HardContacts<D>::correct(double duration) {
  bool is_exact = true;
  for (ContactConstraint<D>& at : planned_) {
    at.gap = search_.predicted_gap(at);
    const double error = at.gap - at.gap_floor - duration * at.normal.dot(at.velocity + kicked(at));
    at.velocity += error / duration * at.normal;
    const bool counts = at.is_bonded || !at.impulse.isZero(0) || at.gap < at.gap_floor;
    if (counts && !(std::abs(error) <= exact_share * search_.reach(std::size_t(at.b)))) is_exact = false;
  }
  return is_exact;
}

/// Contacts that go on have touched when they did. Those that are there when a block's first step begins are
/// bonded, as with springs (Wang et al. 2021, section 2.5).
template <int D>
void HardContacts<D>::remember(Array<ContactConstraint<D>>& found, double time, double duration) const {
  auto before = known_.begin();
  for (ContactConstraint<D>& at : found) {
    while (before != known_.end() && before->key() < at.key()) ++before;
    const bool is_persistent = before != known_.end() && before->key() == at.key();
    at.touched_at = is_persistent ? before->touched_at : time + at.impact_fraction * duration;
    if (is_persistent) {
      at.impact_fraction = 0;
      at.is_persistent = 1;
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

/// The work of a contact's normal impulse that meets such a velocity.
template <int D>
double HardContacts<D>::normal_work(const ContactConstraint<D>& at, const Vector<D>& velocity) const {
  return at.impulse.dot(at.normal) * at.normal.dot(velocity + 0.5 * kicked(at));
}

/// Books what an impulse does that meets such a velocity. Returns the work of its normal part.
template <int D>
double HardContacts<D>::book(const ContactConstraint<D>& at, const Vector<D>& velocity,
                             EnergyLedger& ledger) const {
  const double normal_work = this->normal_work(at, velocity);
  ledger.add_impact_loss(-normal_work);
  ledger.add_friction_loss(normal_work - at.impulse.dot(velocity + 0.5 * kicked(at)));
  ledger.add_outer_work(
      -at.impulse.dot(prescribed_velocity_of(at.of_a, blocks_) - prescribed_velocity_of(at.of_b, blocks_)));
  return normal_work;
}

template <int D>
Vector<D> HardContacts<D>::velocity_of(const ContactConstraint<D>& at) const {
  return halfspace::velocity_of(at.of_a, blocks_) - halfspace::velocity_of(at.of_b, blocks_);
}

/// The impulses of a kick do their own work before all other forces act at a motion's start, and after them
/// at its end. So the energy is kept by the step itself: a body that falls onto a floor loses what it has
/// when it gets there.
template <int D>
void HardContacts<D>::apply_position_impulses(EnergyLedger& ledger) {
  const double half = 0.5 * integrator_.duration();
  for (ContactConstraint<D>& at : planned_) {
    at.applied_velocity_change =
        half * (integrator_.acceleration_of(at.of_a) - integrator_.acceleration_of(at.of_b));
    const double normal_work = book(at, velocity_of(at), ledger);
    const bool is_new = at.touched_at >= motion_began_;
    const bool lies_there = is_new && known_.empty() && !is_approached(at);
    at.is_new_impact = is_new && !lies_there;
    // A contact that is there from the start presses as if it had always done so.
    if (lies_there) at.stored_normal_work = normal_work;
  }
}

template <int D>
bool HardContacts<D>::is_approached(const ContactConstraint<D>& at) const {
  constexpr double little = 1e-6;
  return at.impact_fraction > 0 ||
         at.normal.dot(velocity_of(at)) < -little * at.applied_velocity_change.norm();
}

template <int D>
void HardContacts<D>::break_when_due(ContactConstraint<D>& at) const {
  if (!at.is_bonded || !at.fails(at.velocity + kicked(at))) return;
  at.is_bonded = 0;
  at.area = at.tension_limit = at.cohesion_limit = 0;
}

template <int D>
void HardContacts<D>::look() {
  std::erase_if(planned_, [&](const ContactConstraint<D>& at) {
    return !at.is_bonded && at.impulse.isZero(0) && at.gap > search_.reach(std::size_t(at.b));
  });
  for (ContactConstraint<D>& at : planned_) {
    break_when_due(at);
    search_.place(at);
    if (at.gap < -told_depth * blocks_.radius[std::size_t(at.b)])
      deepest_ = std::max(deepest_, -at.gap / blocks_.thinner(at.a, at.b));
    at.approach_velocity = velocity_of(at) + at.applied_velocity_change;
  }
}

/// Has something touched in this motion?
template <int D>
bool HardContacts<D>::is_impact() const {
  return std::any_of(planned_.begin(), planned_.end(),
                     [](const ContactConstraint<D>& at) { return at.is_new_impact != 0; });
}

/// A blow is over before elements yield to it: what it takes is its own impulses' work.
template <int D>
void HardContacts<D>::find_impact_losses() {
  for (ContactConstraint<D>& at : planned_) at.velocity = at.approach_velocity;
  solve(integrator_.duration());
  for (ContactConstraint<D>& at : planned_) at.impact_loss = -normal_work(at, at.approach_velocity);
}

/// Two that press each other take energy in each second kick and give it back in the next motion's first one.
/// That is not lost.
template <int D>
void HardContacts<D>::book_second(EnergyLedger& ledger, bool is_impact) {
  for (ContactConstraint<D>& at : planned_) {
    const double normal_work = book(at, at.velocity, ledger);
    const double stored_normal_work = is_impact ? -normal_work - at.impact_loss
                                                : 0.5 * at.impulse.dot(at.normal) * at.normal.dot(kicked(at));
    ledger.add_impact_loss(at.stored_normal_work - stored_normal_work);
    at.stored_normal_work = stored_normal_work;
  }
}

template <int D>
void HardContacts<D>::stop(EnergySample& sample, EnergyLedger& ledger) {
  const bool is_impact = this->is_impact();
  if (is_impact) find_impact_losses();
  for (ContactConstraint<D>& at : planned_) at.velocity = velocity_of(at);
  solve(integrator_.duration());
  book_second(ledger, is_impact);
  for (ContactConstraint<D>& at : planned_) break_when_due(at);
  const double rate = integrator_.kicks().rate();
  integrator_.take_kicks(sample);
  for (ContactConstraint<D>& at : planned_) at.force = rate * at.impulse;
  exchange_known(ledger);
  contacts_.end_bonds_without_spring();
}

template <int D>
void HardContacts<D>::exchange_known(EnergyLedger& ledger) {
  auto before = known_.begin();
  for (const ContactConstraint<D>& at : planned_) {
    for (; before != known_.end() && before->key() < at.key(); ++before)
      ledger.add_impact_loss(before->stored_normal_work);
    if (before != known_.end() && before->key() == at.key()) {
      ++before;
    } else {
      ++touches_;
    }
  }
  for (; before != known_.end(); ++before) ledger.add_impact_loss(before->stored_normal_work);
  known_.swap(planned_);
  planned_.clear();
}

template <int D>
bool HardContacts<D>::is_consistent() const {
  const auto is_carried = [&](const MaterialPoint<D>& point, std::int32_t block) {
    if (point.block != block || block < 0 || std::size_t(block) >= blocks_.slot_count()) return false;
    if (!blocks_.lives(std::size_t(block)) || !point.weight.allFinite() || !point.arm.allFinite())
      return false;
    return !blocks_.is_of_mesh(std::size_t(block)) || halfspace::all(point.node, [&](std::int32_t node) {
      return node >= 0 && std::size_t(node) < blocks_.meshes().node_count();
    });
  };
  const auto is_whole = [&](const ContactConstraint<D>& at) {
    return is_carried(at.of_a, at.a) && is_carried(at.of_b, at.b) && at.feature_a >= 0 && at.feature_b >= 0 &&
           (at.meeting == Meeting::corner_and_face || (D == 3 && at.meeting == Meeting::edges)) &&
           at.normal.allFinite() && at.impulse.allFinite() && at.force.allFinite() && is_finite(at.gap) &&
           is_finite(at.stored_normal_work) && is_finite(at.touched_at) && is_nonnegative(at.area);
  };
  return touches_ >= 0 && halfspace::all(known_, is_whole) &&
         std::is_sorted(known_.begin(), known_.end(), precedes<D>);
}

template class HardContacts<2>;
template class HardContacts<3>;

}  // namespace halfspace
