#include <algorithm>
#include <cmath>

#include "world/world.h"

namespace halfspace {
namespace {

double damped(double force, double velocity, double share) {
  return velocity == 0 ? force : force - share * std::abs(force) * (velocity > 0 ? 1 : -1);
}

/// Component of a velocity against which local damping acted, when it had been formed from the velocity before.
double along(double before, double after) { return before == 0 ? 0 : (before > 0 ? after : -after); }

template <class Vector>
double damped_power(const Vector& force, const Vector& before, const Vector& after) {
  double power = 0;
  for (int k = 0; k < force.size(); ++k) power += std::abs(force[k]) * along(before[k], after[k]);
  return power;
}

}  // namespace

template <int D>
typename World<D>::Drive World<D>::drive(std::size_t i) const {
  return {blocks_.force[i] + blocks_.applied_force[i] + blocks_.mass[i] * settings_.gravity,
          blocks_.torque[i] + blocks_.applied_torque[i]};
}

/// Newton's law with local damping (Cundall's, against each component of the velocity) and mass-proportional damping.
template <int D>
void World<D>::accelerate(std::size_t i) {
  auto [force, torque] = drive(i);
  if (settings_.local_damping > 0) {
    for (int k = 0; k < D; ++k) force[k] = damped(force[k], blocks_.velocity[i][k], settings_.local_damping);
    torque = damped(torque, blocks_.spin[i], settings_.local_damping);
  }
  acceleration_[i] = force / blocks_.mass[i] - settings_.mass_damping * blocks_.velocity[i];
  angular_acceleration_[i] = torque / blocks_.inertia[i] - settings_.mass_damping * blocks_.spin[i];
}

/// First half of velocity Verlet: velocities to the middle of the step, positions to its end.
template <int D>
void World<D>::kick_and_drift() {
  const double half = 0.5 * time_step_;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (blocks_.kind[i] == BlockKind::rigid) {
      blocks_.velocity[i] += half * acceleration_[i];
      blocks_.spin[i] += half * angular_acceleration_[i];
    } else if (blocks_.kind[i] != BlockKind::prescribed) {
      continue;
    }
    blocks_.position[i] += time_step_ * blocks_.velocity[i];
    const double turn = time_step_ * blocks_.spin[i];
    if (turn != 0) {
      blocks_.angle[i] += turn;
      blocks_.rotation[i] = blocks_.rotation[i].turned_by(turn);
      blocks_.turn_outline(std::int32_t(i));
    }
    candidates_.note_motion(blocks_, i);
  }
}

/// Second half: velocities to the end of the step, and the ledger.
template <int D>
void World<D>::kick_and_book() {
  const double half = 0.5 * time_step_;
  double kinetic = 0, gravity = 0, local_loss = 0, mass_loss = 0, applied_power = 0, prescribed_power = 0;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (blocks_.kind[i] == BlockKind::prescribed) {
      prescribed_power -= blocks_.force[i].dot(blocks_.velocity[i]) + blocks_.torque[i] * blocks_.spin[i];
    }
    if (blocks_.kind[i] != BlockKind::rigid) continue;
    accelerate(i);
    const double mass = blocks_.mass[i];
    const Vector<D> before = blocks_.velocity[i];
    const double spin_before = blocks_.spin[i];
    applied_power += blocks_.applied_force[i].dot(before) + blocks_.applied_torque[i] * spin_before;
    blocks_.velocity[i] += half * acceleration_[i];
    blocks_.spin[i] += half * angular_acceleration_[i];
    // Work of the damping forces over this half kick and the next one, which is exact at the velocity between them.
    const Vector<D>& after = blocks_.velocity[i];
    const double spin_after = blocks_.spin[i];
    if (settings_.local_damping > 0) {
      const auto [force, torque] = drive(i);
      local_loss += settings_.local_damping * (damped_power(force, before, after) + std::abs(torque) * along(spin_before, spin_after));
    }
    if (settings_.mass_damping > 0) {
      mass_loss += settings_.mass_damping * (mass * before.dot(after) + blocks_.inertia[i] * spin_before * spin_after);
    }
    kinetic += blocks_.kinetic_energy(std::int32_t(i));
    gravity -= mass * settings_.gravity.dot(blocks_.position[i]);
  }
  ledger_.kinetic = kinetic;
  ledger_.gravity = gravity;
  ledger_.local_damping_loss += time_step_ * local_loss;
  ledger_.mass_damping_loss += time_step_ * mass_loss;
  ledger_.outer_work += time_step_ * applied_power + half * (prescribed_power_ + prescribed_power);
  prescribed_power_ = prescribed_power;
}

/// A block that would pass its own radius in one step is out of hand; so is one that is not finite.
template <int D>
bool World<D>::moves_too_far() const {
  const double half = 0.5 * time_step_;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (blocks_.kind[i] != BlockKind::rigid) continue;
    const Vector<D> velocity = blocks_.velocity[i] + half * acceleration_[i];
    const double spin = blocks_.spin[i] + half * angular_acceleration_[i];
    const double moved = time_step_ * (velocity.cwiseAbs().maxCoeff() + blocks_.radius[i] * std::abs(spin));
    if (!(moved <= blocks_.radius[i])) return true;
  }
  return false;
}

/// All but nothing of the energy present was there before: the numbers made it. (Near the stable step, but below it, the
/// ledger of a spring swings by the share q^2 of its energy, q the time step over the stable one.)
template <int D>
bool World<D>::makes_energy() const {
  const double made = ledger_.residual();
  const double present = ledger_.kinetic + ledger_.strain + ledger_.losses();
  return !(made <= 0.995 * present || made <= noise_energy_);
}

template <int D>
StepResult World<D>::prepare() {
  if (edited_) {
    if (!choose_time_step()) return StepResult::no_time_step;
  }
  if (current_) return StepResult::ok;
  detect();
  evaluate_forces(0);
  start_ledger();
  fresh_.clear();
  current_ = true;
  edited_ = false;
  return StepResult::ok;
}

template <int D>
StepResult World<D>::step() {
  if (const StepResult result = prepare(); result != StepResult::ok) return result;
  if (moves_too_far()) return StepResult::unstable;
  kick_and_drift();
  detected_ = false;
  detect();
  evaluate_forces(time_step_);
  kick_and_book();
  ++steps_;
  return makes_energy() ? StepResult::unstable : StepResult::ok;
}

template class World<2>;

}  // namespace halfspace
