#include "world/hard_contact/rigid_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow_phase/features.h"
#include "world/hard_contact/limits.h"

namespace halfspace {
namespace {

/// Fractions of a block's radius. A point nearer to a face than this is on it.
constexpr double reach_fraction = 1e-9;
/// How far blocks may deviate from their motion at constant velocity before the search is repeated.
constexpr double allowance_fraction = 1e-3;

/// Penetration loses this fraction of itself per step.
constexpr double recovery_fraction = 0.1;
constexpr int max_recovery_sweeps = 10;

/// A loaded point this close to its face, or this deep, is settled, as a fraction of the radius.
constexpr double settled_fraction = 1e-6;

/// Points of a manifold are the same from step to step within this fraction of the radius.
constexpr double same_place_fraction = 0.05;

template <int D>
bool is_before(const RigidContact<D>& one, const RigidContact<D>& other) {
  return one.blocks() < other.blocks();
}

/// Unit vectors along a face.
std::array<Vector<2>, 1> tangents(const Vector<2>& normal) { return {perpendicular(normal)}; }
std::array<Vector<3>, 2> tangents(const Vector<3>& normal) {
  const int least = std::abs(normal.x()) <= std::abs(normal.y())
                        ? (std::abs(normal.x()) <= std::abs(normal.z()) ? 0 : 2)
                        : (std::abs(normal.y()) <= std::abs(normal.z()) ? 1 : 2);
  const Vector<3> first = cross_product(normal, Vector<3>::Unit(least)).normalized();
  return {first, cross_product(normal, first)};
}

}  // namespace

template <int D>
PosedBlock<D> RigidContacts<D>::now(std::size_t slot) const {
  return {blocks_.own_outline(std::int32_t(slot)), blocks_.position[slot], blocks_.rotation[slot]};
}

template <int D>
PosedBlock<D> RigidContacts<D>::predicted(std::size_t slot) const {
  if (!blocks_.moves(slot)) return now(slot);
  return {blocks_.own_outline(std::int32_t(slot)),
          blocks_.position[slot] + integrator_.predicted_displacement(slot),
          integrator_.predicted_rotation(slot)};
}

/// At least the rounding of a point's place seen from either block.
template <int D>
double RigidContacts<D>::reach(const RigidContact<D>& contact) const {
  constexpr double roundings = 16 * std::numeric_limits<double>::epsilon();
  const std::size_t a = std::size_t(contact.a), b = std::size_t(contact.b);
  return std::max(reach_fraction * std::min(blocks_.radius[a], blocks_.radius[b]),
                  roundings * std::max(blocks_.position[a].norm(), blocks_.position[b].norm()));
}

template <int D>
double RigidContacts<D>::settled_gap(const RigidContact<D>& contact) const {
  const std::size_t a = std::size_t(contact.a), b = std::size_t(contact.b);
  return std::max(settled_fraction * std::min(blocks_.radius[a], blocks_.radius[b]), reach(contact));
}

/// Faces are chosen where blocks would be by their present velocities: at the start of a motion the end of a
/// flush face would stop a block that slides on to the next, and with gravity a block would sink into it.
template <int D>
void RigidContacts<D>::pose_ahead(double duration) {
  const std::size_t slots = blocks_.slot_count();
  ahead_.resize(slots);
  allowance_.resize(slots);
  for (std::size_t i = 0; i < slots; ++i) {
    if (!blocks_.lives(i)) continue;
    ahead_[i] = now(i);
    allowance_[i] = allowance_fraction * blocks_.radius[i];
    if (!blocks_.moves(i)) continue;
    ahead_[i].position += duration * blocks_.velocity[i];
    ahead_[i].rotation = ahead_[i].rotation.turned_by(Angular<D>(duration * blocks_.spin[i]));
    if (blocks_.moves_freely(i))
      allowance_[i] += duration * duration * integrator_.speed_bound_of(i).acceleration;
  }
}

template <int D>
void RigidContacts<D>::find(double duration) {
  planned_.clear();
  pose_ahead(duration);
  auto before = known_.begin();
  for (const Candidate<D>& pair : contacts_.neighbors().pairs()) {
    if (!model_.law_of(pair).has_no_spring()) continue;
    const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
    const double margin = separation_margin(a, b);
    const double distance = blocks_.radius[a] + blocks_.radius[b] + margin;
    if ((ahead_[a].position - ahead_[b].position).squaredNorm() > distance * distance) continue;
    Planned contact;
    contact.a = pair.a;
    contact.b = pair.b;
    while (before != known_.end() && before->blocks() < contact.blocks()) ++before;
    if (before != known_.end() && before->blocks() == contact.blocks()) contact.manifold = before->manifold;
    if (find_manifold(ahead_[a], ahead_[b], margin, contact.manifold)) planned_.push_back(contact);
  }
}

/// Pairs of blocks that impulses have moved farther than allowed for, and that now overlap unseen. False when
/// there are none.
template <int D>
bool RigidContacts<D>::find_more(double time, double duration) {
  const auto deviates = [&](std::size_t i) {
    if (!blocks_.moves_freely(i)) return false;
    const PosedBlock<D> at = predicted(i);
    const double deviation = (at.position - ahead_[i].position).norm() +
                             blocks_.radius[i] * at.rotation.farthest_from(ahead_[i].rotation);
    return deviation > allowance_[i];
  };
  const std::size_t before = planned_.size();
  for (const Candidate<D>& pair : contacts_.neighbors().pairs()) {
    if (!model_.law_of(pair).has_no_spring()) continue;
    const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
    if (!deviates(a) && !deviates(b)) continue;
    const PosedBlock<D> at_a = predicted(a), at_b = predicted(b);
    const double distance = blocks_.radius[a] + blocks_.radius[b];
    if ((at_a.position - at_b.position).squaredNorm() > distance * distance) continue;
    Planned contact;
    contact.a = pair.a;
    contact.b = pair.b;
    if (std::binary_search(planned_.begin(), planned_.begin() + std::ptrdiff_t(before), contact,
                           is_before<D>))
      continue;
    if (!find_manifold(at_a, at_b, 0, contact.manifold)) continue;
    start(contact, time, duration);
    planned_.push_back(contact);
  }
  if (planned_.size() == before) return false;
  std::sort(planned_.begin(), planned_.end(), is_before<D>);
  return true;
}

template <int D>
void RigidContacts<D>::set_gaps(Planned& contact) const {
  const PosedBlock<D> a = now(std::size_t(contact.a)), b = now(std::size_t(contact.b));
  contact.normal = normal_of(contact.manifold, a, b);
  for (std::size_t i = 0; i < std::size_t(contact.manifold.count); ++i)
    contact.gap[i] = gap_of(contact.manifold, i, contact.normal, a, b);
}

template <int D>
double RigidContacts<D>::predicted_gap(const Planned& contact, std::size_t point) const {
  const PosedBlock<D> a = predicted(std::size_t(contact.a)), b = predicted(std::size_t(contact.b));
  return gap_of(contact.manifold, point, normal_of(contact.manifold, a, b), a, b);
}

/// Impulses of the last motion at the same places, by either block: on a flush face the points may have
/// changed their order and their owner.
template <int D>
void RigidContacts<D>::warm_start(double duration) {
  const double scale = duration_ > 0 ? duration / duration_ : 1;
  auto before = known_.begin();
  for (Planned& contact : planned_) {
    while (before != known_.end() && before->blocks() < contact.blocks()) ++before;
    contact.is_new = before == known_.end() || before->blocks() != contact.blocks();
    if (contact.is_new) continue;
    contact.touched_at = before->touched_at;
    contact.stored_work = before->stored_work;
    const std::size_t a_slot = std::size_t(contact.a), b_slot = std::size_t(contact.b);
    const PosedBlock<D> a = now(a_slot), b = now(b_slot);
    const double near = same_place_fraction * std::min(blocks_.radius[a_slot], blocks_.radius[b_slot]);
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
    contact.friction = scale * before->friction;
    contact.couple = scale * before->couple;
  }
}

/// The middle of the points that touch, on the plane of the manifold, and their mean distance from it.
/// Friction acts there.
template <int D>
typename RigidContacts<D>::Patch RigidContacts<D>::patch_of(
    const Planned& at, const std::array<Vector<D>, max_manifold_points<D>>& arm) const {
  const std::size_t count = std::size_t(at.manifold.count);
  const double nearest = *std::min_element(at.gap.begin(), at.gap.begin() + at.manifold.count);
  const double touching = nearest + settled_gap(at);
  const double towards_plane = at.manifold.plane == ManifoldPlane::face_of_b ? 1 : -1;
  Patch patch{Vector<D>::Zero(), 0};
  double touching_count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (at.gap[i] > touching) continue;
    patch.center += arm[i] + towards_plane * at.gap[i] * at.normal;
    ++touching_count;
  }
  patch.center /= touching_count;
  for (std::size_t i = 0; i < count; ++i) {
    if (at.gap[i] <= touching) patch.radius += (arm[i] - patch.center).norm() / touching_count;
  }
  return patch;
}

template <int D>
void RigidContacts<D>::build_rows(const Array<Planned>& contacts) {
  problem_.contacts.clear();
  problem_.rows.clear();
  const auto add_row = [&](const ImpulseContact<D>& contact, const Vector<D>& direction,
                           const Angular<D>& turn_a, const Angular<D>& turn_b, double impulse) {
    const std::size_t a = std::size_t(contact.a), b = std::size_t(contact.b);
    ImpulseRow<D> row;
    row.direction = direction;
    row.turn_a = turn_a;
    row.turn_b = turn_b;
    row.response_a = contact.inverse_mass_a > 0 ? blocks_.inertia[a].spin(turn_a, blocks_.rotation[a])
                                                : Angular<D>(Angular<D>::Zero());
    row.response_b = contact.inverse_mass_b > 0 ? blocks_.inertia[b].spin(turn_b, blocks_.rotation[b])
                                                : Angular<D>(Angular<D>::Zero());
    row.inverse_mass = (contact.inverse_mass_a + contact.inverse_mass_b) * direction.squaredNorm() +
                       turn_a.dot(row.response_a) + turn_b.dot(row.response_b);
    row.target = 0;
    row.impulse = impulse;
    problem_.rows.push_back(row);
  };
  for (const Planned& at : contacts) {
    const std::size_t a = std::size_t(at.a), b = std::size_t(at.b);
    const PosedBlock<D> pose_a = now(a), pose_b = now(b);
    const Vector<D> to_b = pose_b.position - pose_a.position;
    ImpulseContact<D> contact;
    contact.a = at.a;
    contact.b = at.b;
    contact.first_row = std::int32_t(problem_.rows.size());
    contact.normal_count = at.manifold.count;
    contact.inverse_mass_a = blocks_.moves_freely(a) ? 1 / blocks_.mass[a] : 0;
    contact.inverse_mass_b = blocks_.moves_freely(b) ? 1 / blocks_.mass[b] : 0;
    contact.tan_friction = model_.law_between(a, b).tan_friction;
    contact.friction_count = contact.tan_friction <= 0 ? 0 : D == 2 ? 1 : 3;
    contact.couple_arm = 0;
    std::array<Vector<D>, max_manifold_points<D>> arm;
    for (std::size_t i = 0; i < std::size_t(at.manifold.count); ++i) {
      arm[i] = arm_of(at.manifold, i, pose_a, pose_b);
      add_row(contact, at.normal, moment(arm[i], at.normal), moment(Vector<D>(arm[i] - to_b), at.normal),
              at.impulse[i]);
    }
    if (contact.friction_count > 0) {
      const Patch patch = patch_of(at, arm);
      const Vector<D> from_b = patch.center - to_b;
      for (const Vector<D>& tangent : tangents(at.normal))
        add_row(contact, tangent, moment(patch.center, tangent), moment(from_b, tangent),
                tangent.dot(at.friction));
      if constexpr (D == 3) add_row(contact, Vector<D>::Zero(), at.normal, at.normal, at.couple);
      contact.couple_arm = patch.radius;
    }
    problem_.contacts.push_back(contact);
  }
}

/// An impact reverses the velocity of approach at its time within the step, and the rest of the step is free
/// flight: for blocks under constant forces that is exact.
template <int D>
void RigidContacts<D>::find_impacts(double time, double duration) {
  std::size_t c = 0;
  for (Planned& contact : planned_) {
    ImpulseContact<D>& of = problem_.contacts[c++];
    const std::span<ImpulseRow<D>> rows = problem_.normals_of(of);
    const double restitution = model_.law_between(std::size_t(contact.a), std::size_t(contact.b)).restitution;
    const BlockMotion<D> a = motion(std::size_t(contact.a)), b = motion(std::size_t(contact.b));
    double first = HUGE_VAL;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].impulse > 0) continue;
      const double opening = rows[i].velocity(a, b);
      const double acceleration = 2 / duration * (problem_.velocity_along(of, rows[i]) - opening);
      const double gap = std::max(0.0, contact.gap[i]);
      const double end = gap + duration * (opening + 0.5 * acceleration * duration);
      const double square = opening * opening - 2 * acceleration * gap;
      constexpr double little = 1e-6;
      const bool is_approached = gap > 0 || opening < -little * std::abs(acceleration) * duration;
      if (!(end < 0) || !is_approached || !(square > 0)) continue;
      const double speed = std::sqrt(square);
      const double at = std::clamp(2 * gap / (speed - opening), 0.0, duration);
      const double rest = duration - at;
      contact.is_impact = true;
      first = std::min(first, at);
      if (restitution == 0) continue;
      contact.rebound[i] = std::max(0.0, restitution * speed + acceleration * rest);
      contact.rebound_gap[i] = std::max(0.0, rest * (restitution * speed + 0.5 * acceleration * rest));
    }
    if (contact.is_new) contact.touched_at = time + std::min(first, duration);
  }
}

/// Penetration stays as it is: the points of a jammed heap could not all recover in one solve, so that their
/// impulses would grow without end. A loaded point that is settled on its face keeps its gap, too.
template <int D>
double RigidContacts<D>::gap_floor(const Planned& contact, std::size_t point) const {
  const double gap = contact.gap[point];
  if (contact.rebound_gap[point] > 0) return contact.rebound_gap[point];
  return contact.was_loaded[point] && gap <= settled_gap(contact) ? gap : std::min(gap, 0.0);
}

template <int D>
void RigidContacts<D>::set_position_targets(double duration) {
  for (std::size_t c = 0; c < planned_.size(); ++c) {
    const Planned& contact = planned_[c];
    const std::span<ImpulseRow<D>> rows = problem_.normals_of(problem_.contacts[c]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double end = predicted_gap(contact, i);
      const double free = problem_.velocity_along(problem_.contacts[c], rows[i]);
      rows[i].target = free - (end - gap_floor(contact, i)) / duration;
    }
  }
}

/// Gaps also change as their normals turn, which the linear rows leave out. True when the change since the
/// last solution is below the tolerance.
template <int D>
bool RigidContacts<D>::correct_targets(double duration) {
  bool is_accurate = true;
  for (std::size_t c = 0; c < planned_.size(); ++c) {
    const Planned& contact = planned_[c];
    const std::span<ImpulseRow<D>> rows = problem_.normals_of(problem_.contacts[c]);
    const double tolerance = gap_tolerance * reach(contact);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double excess = predicted_gap(contact, i) - gap_floor(contact, i);
      const double error =
          excess / duration - (problem_.velocity_along(problem_.contacts[c], rows[i]) - rows[i].target);
      rows[i].target -= error;
      const bool is_active = rows[i].impulse > 0 || excess < 0;
      if (is_active && !(duration * std::abs(error) <= tolerance)) is_accurate = false;
    }
  }
  return is_accurate;
}

/// From velocities without impulses.
template <int D>
bool RigidContacts<D>::solve(double duration) {
  const ImpulseSettings settings{.speed = duration * model_.settings.gravity.norm()};
  const ImpulseResult result = solver_.solve(problem_, settings);
  iterations_ += result.iterations;
  changes().begin(duration);
  std::size_t c = 0;
  for (Planned& contact : planned_) {
    const ImpulseContact<D>& of = problem_.contacts[c++];
    Vector<D> impulse = Vector<D>::Zero();
    Angular<D> turn_a = Angular<D>::Zero(), turn_b = Angular<D>::Zero();
    const auto add = [&](const ImpulseRow<D>& row) {
      impulse += row.impulse * row.direction;
      turn_a += row.impulse * row.turn_a;
      turn_b += row.impulse * row.turn_b;
      return row.impulse;
    };
    std::size_t i = 0;
    for (const ImpulseRow<D>& row : problem_.normals_of(of)) contact.impulse[i++] = add(row);
    contact.friction.setZero();
    for (const ImpulseRow<D>& row : problem_.frictions_of(of)) {
      contact.friction += row.impulse * row.direction;
      contact.couple = add(row);  // of the last row in space
    }
    changes().push(std::size_t(of.a), -impulse, -turn_a);
    changes().push(std::size_t(of.b), impulse, turn_b);
  }
  return result.has_converged;
}

/// As it is now.
template <int D>
BlockMotion<D> RigidContacts<D>::motion(std::size_t i) const {
  if (!blocks_.lives(i) || !blocks_.moves(i)) return {};
  return {blocks_.velocity[i], blocks_.spin[i]};
}

template <int D>
void RigidContacts<D>::set_motions() {
  problem_.motions.resize(blocks_.slot_count());
  for (std::size_t i = 0; i < problem_.motions.size(); ++i) problem_.motions[i] = motion(i);
}

template <int D>
void RigidContacts<D>::set_masses() {
  problem_.masses.resize(blocks_.slot_count());
  for (std::size_t i = 0; i < problem_.masses.size(); ++i) {
    MassMatrix<D>& mass = problem_.masses[i];
    mass.setZero();
    if (blocks_.kind[i] != BlockKind::rigid) continue;
    mass.diagonal().template head<D>().setConstant(blocks_.mass[i]);
    constexpr int turns = D == 2 ? 1 : 3;
    for (int k = 0; k < turns; ++k)
      mass.template block<turns, 1>(D, D + k) =
          blocks_.inertia[i].momentum(Angular<D>(Angular<D>::Unit(k)), blocks_.rotation[i]);
  }
}

template <int D>
void RigidContacts<D>::set_motions_at_half_step() {
  set_motions();
  for (std::size_t i = 0; i < problem_.motions.size(); ++i) {
    if (blocks_.kind[i] == BlockKind::rigid) problem_.motions[i] = integrator_.motion_at_half_step(i);
  }
}

template <int D>
bool RigidContacts<D>::predict(double time, double duration) {
  find(duration);
  if (planned_.empty()) return true;
  for (Planned& contact : planned_) set_gaps(contact);
  warm_start(duration);
  set_masses();
  for (int searches = 1;; ++searches) {
    build_rows(planned_);
    set_motions_at_half_step();
    if (searches == 1) find_impacts(time, duration);
    set_position_targets(duration);
    for (int i = 0; i < max_corrections; ++i) {
      const bool has_converged = solve(duration);
      if (!integrator_.predict(duration)) return false;
      if (correct_targets(duration) || !has_converged) break;
      set_motions_at_half_step();
    }
    if (searches == max_searches || !find_more(time, duration)) break;
    changes().begin(duration);
    if (!integrator_.predict(duration)) return false;
  }
  next_known_.reserve(planned_.size());
  return true;
}

template <int D>
void RigidContacts<D>::start(Planned& contact, double time, double duration) const {
  set_gaps(contact);
  contact.touched_at = time + duration;
  contact.is_impact = true;
}

/// The work of a contact's impulses, by the velocities before and after them: of the normal ones a loss by
/// impact, of friction a loss by friction, on prescribed blocks work from outside. Returns the normal one.
template <int D>
double RigidContacts<D>::book(std::size_t c, EnergyLedger& ledger) {
  const ImpulseContact<D>& contact = problem_.contacts[c];
  const std::size_t a = std::size_t(contact.a), b = std::size_t(contact.b);
  const BlockMotion<D> motion_a = motion(a), motion_b = motion(b);
  const BlockMotion<D> change_a = changes().of_motion(a), change_b = changes().of_motion(b);
  const auto prescribed = [&](std::size_t i, const BlockMotion<D>& motion) {
    return blocks_.kind[i] == BlockKind::prescribed ? motion : BlockMotion<D>{};
  };
  const BlockMotion<D> given_a = prescribed(a, motion_a), given_b = prescribed(b, motion_b);
  const auto work_of = [&](std::span<const ImpulseRow<D>> rows) {
    double work = 0;
    for (const ImpulseRow<D>& row : rows) {
      work += row.impulse * (row.velocity(motion_a, motion_b) + 0.5 * row.velocity(change_a, change_b));
      ledger.add_outer_work(-row.impulse * row.velocity(given_a, given_b));
    }
    return work;
  };
  const double normal_work = work_of(problem_.normals_of(contact));
  ledger.add_impact_loss(-normal_work);
  ledger.add_friction_loss(-work_of(problem_.frictions_of(contact)));
  return normal_work;
}

/// Loaded contacts store energy in each second half step and release it in the first of the next motion. That
/// is no loss.
template <int D>
double RigidContacts<D>::stored_work(std::size_t c) {
  const ImpulseContact<D>& contact = problem_.contacts[c];
  const BlockMotion<D> change_a = changes().of_motion(std::size_t(contact.a));
  const BlockMotion<D> change_b = changes().of_motion(std::size_t(contact.b));
  double work = 0;
  for (const ImpulseRow<D>& row : problem_.normals_of(contact))
    work += 0.5 * row.impulse * row.velocity(change_a, change_b);
  return work;
}

template <int D>
void RigidContacts<D>::apply_position_impulses(EnergyLedger& ledger) {
  for (std::size_t c = 0; c < planned_.size(); ++c) {
    const double normal_work = book(c, ledger);
    // A contact that is there from the start carries its load from the start.
    if (known_.empty() && !planned_[c].is_impact) planned_[c].stored_work = normal_work;
  }
}

/// Moves blocks apart that overlap, without a change of their velocities. Returns the change of their
/// potential energy.
template <int D>
double RigidContacts<D>::recover() {
  const auto overlaps = [&](const Planned& contact) {
    const auto first = contact.gap.begin();
    return *std::min_element(first, first + contact.manifold.count) < -settled_gap(contact);
  };
  if (std::none_of(planned_.begin(), planned_.end(), overlaps)) return 0;
  build_rows(planned_);
  problem_.motions.assign(blocks_.slot_count(), {});  // displacements
  for (std::size_t c = 0; c < planned_.size(); ++c) {
    const Planned& contact = planned_[c];
    problem_.contacts[c].friction_count = 0;
    const std::span<ImpulseRow<D>> rows = problem_.normals_of(problem_.contacts[c]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].impulse = 0;
      rows[i].target = -std::max(0.0, contact.gap[i]) +
                       recovery_fraction * std::max(0.0, -contact.gap[i] - settled_gap(contact));
    }
  }
  solver_.sweep_only(problem_, max_recovery_sweeps);
  double energy = 0;
  for (std::size_t i = 0; i < problem_.motions.size(); ++i) {
    const BlockMotion<D>& displacement = problem_.motions[i];
    if (displacement.velocity.isZero(0) && displacement.spin.isZero(0)) continue;
    integrator_.displace(i, displacement);
    energy -= blocks_.mass[i] * model_.settings.gravity.dot(displacement.velocity);
  }
  for (Planned& contact : planned_) set_gaps(contact);
  return energy;
}

template <int D>
void RigidContacts<D>::find_at_end(EnergyLedger& ledger) {
  for (Planned& contact : planned_) set_gaps(contact);
  ledger.add_impact_loss(-recover());
  for (const Planned& contact : planned_) {
    for (std::size_t i = 0; i < std::size_t(contact.manifold.count); ++i) {
      const double depth = -contact.gap[i] / blocks_.thinner(contact.a, contact.b);
      if (depth > reported_depth) deepest_ = std::max(deepest_, depth);
    }
  }
  std::erase_if(planned_, [&](const Planned& contact) {
    if (contact.normal_impulse() > 0) return false;
    const auto first = contact.gap.begin();
    return *std::min_element(first, first + contact.manifold.count) > reach(contact);
  });
}

/// Points that neither bear nor are on their face have no target.
template <int D>
void RigidContacts<D>::set_velocity_targets() {
  for (std::size_t c = 0; c < planned_.size(); ++c) {
    const Planned& contact = planned_[c];
    const std::span<ImpulseRow<D>> rows = problem_.normals_of(problem_.contacts[c]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const bool touches = rows[i].impulse > 0 || contact.gap[i] <= reach(contact);
      rows[i].target = touches ? contact.rebound[i] : -HUGE_VAL;
    }
  }
}

template <int D>
void RigidContacts<D>::stop_approach(EnergyLedger& ledger) {
  const double duration = integrator_.duration();
  if (!planned_.empty()) {
    build_rows(planned_);
    set_masses();
    set_motions();
    set_velocity_targets();
    solve(duration);
  }
  next_known_.clear();
  auto before = known_.begin();
  for (std::size_t c = 0; c < planned_.size(); ++c) {
    Planned& contact = planned_[c];
    book(c, ledger);
    const double stored = contact.is_impact ? 0 : stored_work(c);
    ledger.add_impact_loss(contact.stored_work - stored);
    contact.stored_work = stored;
    touches_ += contact.is_new;
    for (; before != known_.end() && before->blocks() < contact.blocks(); ++before)
      ledger.add_impact_loss(before->stored_work);
    if (before != known_.end() && before->blocks() == contact.blocks()) ++before;
    next_known_.push_back(contact);
  }
  for (; before != known_.end(); ++before) ledger.add_impact_loss(before->stored_work);
  known_.swap(next_known_);
  planned_.clear();
  duration_ = duration;
}

template <int D>
Vector<D> RigidContacts<D>::force_of(const RigidContact<D>& contact) const {
  const Vector<D> impulse = contact.normal_impulse() * contact.normal + contact.friction;
  return duration_ > 0 ? Vector<D>(2 / duration_ * impulse) : Vector<D>(Vector<D>::Zero());
}

template <int D>
bool RigidContacts<D>::names_features(const Manifold<D>& manifold, std::int32_t a, std::int32_t b) const {
  const Outline<D> own_a = blocks_.own_outline(a), own_b = blocks_.own_outline(b);
  if (manifold.count < 1 || manifold.count > max_manifold_points<D>) return false;
  switch (manifold.plane) {
    case ManifoldPlane::face_of_a:
      return is_below(manifold.feature, own_a.face_count());
    case ManifoldPlane::face_of_b:
      return is_below(manifold.feature, own_b.face_count());
    case ManifoldPlane::edges:
      return D == 3 && is_below(manifold.feature, own_a.edge_count()) &&
             is_below(manifold.other_feature, own_b.edge_count());
    default:
      return false;
  }
}

template <int D>
bool RigidContacts<D>::is_consistent() const {
  const auto is_valid = [&](const RigidContact<D>& at) {
    const auto is_rigid = [&](std::int32_t block) {
      return block >= 0 && std::size_t(block) < blocks_.slot_count() && blocks_.lives(std::size_t(block)) &&
             !blocks_.is_deformable(std::size_t(block));
    };
    return is_rigid(at.a) && is_rigid(at.b) && names_features(at.manifold, at.a, at.b) &&
           halfspace::all(at.manifold.point, [](const Vector<D>& point) { return point.allFinite(); }) &&
           halfspace::all(at.impulse, is_nonnegative) && at.friction.allFinite() && is_finite(at.couple) &&
           halfspace::all(at.gap, is_finite) && at.normal.allFinite() && is_finite(at.touched_at) &&
           is_finite(at.stored_work);
  };
  return touches_ >= 0 && is_nonnegative(duration_) && halfspace::all(known_, is_valid) &&
         std::is_sorted(known_.begin(), known_.end(), is_before<D>);
}

template class RigidContacts<2>;
template class RigidContacts<3>;

}  // namespace halfspace
