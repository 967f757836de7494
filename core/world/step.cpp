#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <utility>

#include "block/free_turn.h"
#include "world/local_damping.h"
#include "world/world.h"

namespace halfspace {
namespace {

/// Of what a tuple refers to, with arrays in the given memory.
template <class... T>
std::tuple<T...> copies_of(const std::tuple<T&...>& originals, Memory* memory) {
  return {std::allocator_arg, std::pmr::polymorphic_allocator<std::byte>(memory), originals};
}

}  // namespace

template <int D>
typename World<D>::Drive World<D>::drive(std::size_t i) const {
  return {blocks_.force[i] + blocks_.applied_force[i] + blocks_.mass[i] * settings_.gravity,
          blocks_.torque[i] + blocks_.applied_torque[i]};
}

/// Newton's law with local damping (Cundall's, against each component of the velocity) and mass-proportional
/// damping.
template <int D>
void World<D>::accelerate_rigid(std::size_t i) {
  auto [force, torque] = drive(i);
  if (settings_.local_damping > 0) {
    for (int k = 0; k < D; ++k) force[k] = damped(force[k], blocks_.velocity[i][k], settings_.local_damping);
    for (int k = 0; k < torque.size(); ++k)
      torque[k] = damped(torque[k], blocks_.spin[i][k], settings_.local_damping);
  }
  acceleration_[i] = force / blocks_.mass[i] - settings_.mass_damping * blocks_.velocity[i];
  momentum_rate_[i] = torque - settings_.mass_damping * blocks_.momentum[i];
}

template <int D>
void World<D>::accelerate(std::size_t i) {
  blocks_.is_affine(i) ? accelerate_affine(i) : accelerate_rigid(i);
}

/// Plans the coming motion: false when it is not finite or presses a block flat: out of hand. Brings the
/// neighbour list up to date when the motion would use it up. All memory is taken here, so that a motion once
/// begun is finished.
template <int D>
bool World<D>::plan_motion(double duration) {
  duration_ = duration;
  most_turned_ = longest_motion_ = 0;
  candidates_.begin_plan();
  const double half = 0.5 * duration_;
  next_rotation_.resize(blocks_.slot_count());
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    const bool rigid = blocks_.kind[i] == BlockKind::rigid;
    if (!rigid && blocks_.is_affine(i)) {
      if (!plan_affine(i)) return false;
      continue;
    }
    if (!rigid && blocks_.kind[i] != BlockKind::prescribed) continue;
    Vector<D> velocity = blocks_.velocity[i];
    Angular<D> spin = blocks_.spin[i];
    if (rigid) {
      velocity += half * acceleration_[i];
      const Angular<D> momentum = blocks_.momentum[i] + half * momentum_rate_[i];
      const auto onward = turned_freely(blocks_.rotation[i], blocks_.inertia[i], momentum, duration_);
      spin = onward.spin;
      next_rotation_[i] = onward.rotation;
    } else {
      next_rotation_[i] = blocks_.rotation[i].turned_by(duration_ * spin);
    }
    const double turn =
        std::max(duration_ * spin.norm(), next_rotation_[i].farthest_from(blocks_.rotation[i]));
    if (!plan_block(i, velocity, turn)) return false;
  }
  if (candidates_.used_up()) renew_candidates();
  return true;
}

/// Announces how far a block moves that turns, or strains, by so much: false when that is not finite.
template <int D>
bool World<D>::plan_block(std::size_t i, const Vector<D>& velocity, double turn) {
  const double motion = duration_ * velocity.norm() + blocks_.radius[i] * turn;
  if (!std::isfinite(motion)) return false;
  candidates_.plan(blocks_, i, motion);
  if (motion > blocks_.radius[i]) candidates_.plan_way(i, duration_ * velocity);
  most_turned_ = std::max(most_turned_, turn);
  longest_motion_ = std::max(longest_motion_, motion);
  return true;
}

/// First half of velocity Verlet: velocities to the middle of the step, positions to its end.
template <int D>
void World<D>::kick_and_drift() {
  const double half = 0.5 * duration_;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (blocks_.kind[i] == BlockKind::rigid) {
      blocks_.push(i, half * acceleration_[i], half * momentum_rate_[i]);
    } else if (blocks_.is_affine(i)) {
      kick_and_drift_affine(i);
      continue;
    } else if (blocks_.kind[i] != BlockKind::prescribed) {
      continue;
    }
    blocks_.drift(std::int32_t(i), duration_ * blocks_.velocity[i], next_rotation_[i]);
    if constexpr (D == 2) blocks_.angle[i] += duration_ * blocks_.spin[i][0];
  }
}

/// A block's energies, and the rates at which prescribed motion and damping change the world's. `opposed` is
/// the velocity that damping was formed with.
template <int D>
void World<D>::take_stock(std::size_t i, const Vector<D>& opposed, const Angular<D>& opposed_spin,
                          Stock& stock) const {
  const Vector<D>& velocity = blocks_.velocity[i];
  const Angular<D>& spin = blocks_.spin[i];
  stock.power.contact_damping += dashpot_power(i);
  if (blocks_.kind[i] == BlockKind::prescribed) {
    stock.power.outer -= blocks_.force[i].dot(velocity) + blocks_.torque[i].dot(spin);
  }
  if (blocks_.kind[i] != BlockKind::rigid) return;
  const double mass = blocks_.mass[i];
  stock.squared_speed = std::max(stock.squared_speed, velocity.squaredNorm());
  const double radius = blocks_.radius[i];
  stock.squared_swing = std::max(stock.squared_swing, radius * radius * spin.squaredNorm());
  stock.kinetic += blocks_.kinetic_energy(std::int32_t(i));
  stock.gravity -= mass * settings_.gravity.dot(blocks_.position[i]);
  if (settings_.local_damping > 0) {
    const auto [force, torque] = drive(i);
    double power = 0;
    for (int k = 0; k < torque.size(); ++k) power += damped_power(torque[k], opposed_spin[k], spin[k]);
    for (int k = 0; k < D; ++k) power += damped_power(force[k], opposed[k], velocity[k]);
    stock.power.local_damping += settings_.local_damping * power;
  }
  if (settings_.mass_damping > 0) {
    stock.power.mass_damping +=
        settings_.mass_damping * (mass * opposed.dot(velocity) + opposed_spin.dot(blocks_.momentum[i]));
  }
}

/// Second half: velocities to the end of the step, and the ledger. Powers are known at both ends of the step:
/// the trapezoid between them is as exact as the step itself.
template <int D>
void World<D>::kick_and_book() {
  const double half = 0.5 * duration_;
  Stock stock;
  double applied_power = 0;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    const Vector<D> middle_velocity = blocks_.velocity[i];
    const Angular<D> middle_spin = blocks_.spin[i];
    if (blocks_.kind[i] == BlockKind::rigid) {
      accelerate_rigid(i);
      applied_power +=
          blocks_.applied_force[i].dot(middle_velocity) + blocks_.applied_torque[i].dot(middle_spin);
      // One beyond all numbers is none: the next motion, which is planned with it, is refused as unstable.
      if (acceleration_[i].allFinite() && momentum_rate_[i].allFinite())
        blocks_.kick(i, half * acceleration_[i], half * momentum_rate_[i]);
    } else if (blocks_.is_affine(i)) {
      kick_and_book_affine(i, stock, applied_power);
      continue;
    }
    take_stock(i, middle_velocity, middle_spin, stock);
  }
  ledger_.kinetic = stock.kinetic;
  ledger_.gravity = stock.gravity;
  ledger_.block_strain = stock.block_strain;
  ledger_.contact_damping_loss += half * (power_.contact_damping + stock.power.contact_damping);
  ledger_.local_damping_loss += half * (power_.local_damping + stock.power.local_damping);
  ledger_.mass_damping_loss += half * (power_.mass_damping + stock.power.mass_damping);
  ledger_.block_damping_loss += half * (power_.block_damping + stock.power.block_damping);
  ledger_.outer_work += duration_ * applied_power + half * (power_.outer + stock.power.outer);
  note_speeds(stock);
  power_ = stock.power;
}

/// All but nothing of the energy present was there before: the numbers made it. (Near the stable step, but
/// below it, the ledger of a spring swings by the share q^2 of its energy, q the time step over the stable
/// one.)
template <int D>
bool World<D>::makes_energy() const {
  const double made = ledger_.residual();
  const double present = ledger_.kinetic + ledger_.strain + ledger_.block_strain + ledger_.losses();
  return !(made <= 0.995 * present || made <= noise_energy_);
}

template <int D>
StepResult World<D>::prepare() {
  if (!edited_) return StepResult::ok;
  // Memory of blocks is taken first, that of pairs by detection: contacts are found only when there is all of
  // it.
  const std::size_t slots = blocks_.slot_count();
  hardness_.reserve(slots);
  acceleration_.reserve(slots);
  momentum_rate_.reserve(slots);
  if (!choose_time_step()) return StepResult::no_time_step;
  acceleration_.resize(slots, Vector<D>::Zero());
  momentum_rate_.resize(slots, Angular<D>::Zero());
  evaluate_forces(0);
  start_ledger();
  edited_ = false;
  return StepResult::ok;
}

template <int D>
void World<D>::evaluate_forces_for_host(double elapsed) {
  edit();  // springs and losses change outside the steps
  evaluate_forces(elapsed);
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i)
    ledger_.contact_damping_loss += elapsed * dashpot_power(i);
  candidates_.tidy_plans();
  fix_potential_length();
}

/// From where forces are known to where they are known again.
template <int D>
void World<D>::move() {
  fix_potential_length();
  kick_and_drift();
  detected_ = false;
  made_ = duration_;
  evaluate_forces(duration_);
  made_ = 0;
  kick_and_book();
  candidates_.tidy_plans();
}

/// Plans what is left of the step: in one go, or as much of it as fast blocks may do at once.
template <int D>
StepResult World<D>::plan_rest() {
  if (makes_energy() || !plan_motion(time_step_ - passed_)) return StepResult::unstable;
  return divide();
}

template <int D>
StepResult World<D>::prepare_and_plan() {
  if (any_fresh_) make_bonds();
  const StepResult result = prepare();
  return result == StepResult::ok ? plan_rest() : result;
}

/// Of a changed world the contacts are found and bonds made before it shows how much memory the motion takes:
/// when there is too little, what was known before is put back.
template <int D>
StepResult World<D>::plan_changed() {
  renew_used_up_candidates();
  candidates_.remember_pairs();
  const auto before = copies_of(preparation(), touching_.get_allocator().resource());
  try {
    return prepare_and_plan();
  } catch (const std::bad_alloc&) {
    candidates_.recall_pairs();
    preparation() = before;  // every array has room for what it held: this takes no memory
    throw;
  }
}

/// Motion by motion: one, unless fast blocks divide the step. What would take very many is refused where it
/// has come to, and may be gone on with.
template <int D>
StepResult World<D>::step() {
  int motions = 0;
  StepResult result = edited_ || any_fresh_ ? plan_changed() : plan_rest();
  for (;; result = plan_rest()) {
    if (result != StepResult::ok) return result;
    const double rest = time_step_ - passed_;
    const bool is_last = duration_ >= rest;
    if (passed_ == 0 && !is_last) ++divided_steps_;
    move();
    if (is_last) break;
    passed_ += duration_;
    if (++motions == most_motions) return any_fast() ? StepResult::too_fast : StepResult::unstable;
  }
  passed_ = 0;
  ++steps_;
  return StepResult::ok;
}

template class World<2>;
template class World<3>;

}  // namespace halfspace
