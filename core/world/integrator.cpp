#include "world/integrator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "block/free_turn.h"
#include "world/local_damping.h"

namespace halfspace {

template <int D>
typename Integrator<D>::Drive Integrator<D>::drive(std::size_t i) const {
  return {blocks_.force[i] + blocks_.applied_force[i] + blocks_.mass[i] * settings_.gravity,
          blocks_.torque[i] + blocks_.applied_torque[i]};
}

/// Newton's law with local damping (Cundall's, against each component of the velocity) and mass-proportional
/// damping.
template <int D>
void Integrator<D>::accelerate_rigid(std::size_t i) {
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
void Integrator<D>::accelerate(std::size_t i) {
  blocks_.is_affine(i) ? accelerate_affine(i) : accelerate_rigid(i);
}

/// A block's energies, and the rates at which prescribed motion and damping change the world's. `opposed` is
/// the velocity that damping was formed with. Inlined by force: called, it would hand its sums over through
/// memory, block by block.
template <int D>
[[gnu::always_inline]] inline void Integrator<D>::take_stock(std::size_t i, const Vector<D>& opposed,
                                                             const Angular<D>& opposed_spin,
                                                             Stock& stock) const {
  const Vector<D>& velocity = blocks_.velocity[i];
  const Angular<D>& spin = blocks_.spin[i];
  stock.power.contact_damping += forces_.dashpot_power(i);
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

template <int D>
Stock Integrator<D>::begin(double time_step, double& noise) {
  Stock stock;
  double weight_times_size = 0, rounding_energy = 0;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (blocks_.moves_freely(i)) {
      accelerate(i);
      weight_times_size += blocks_.mass[i] * settings_.gravity.norm() * blocks_.radius[i];
      const double reach = blocks_.position[i].norm() + blocks_.radius[i];
      const double speed = std::numeric_limits<double>::epsilon() * reach / time_step;
      rounding_energy += blocks_.mass[i] * speed * speed;
    }
    if (blocks_.is_affine(i)) {
      take_affine_stock(i, blocks_.velocity[i], blocks_.deformation(i).rate, stock);
    } else {
      take_stock(i, blocks_.velocity[i], blocks_.spin[i], stock);
    }
  }
  noise = weight_times_size + rounding_energy;
  return stock;
}

template <int D>
bool Integrator<D>::plan(double duration) {
  duration_ = duration;
  most_turned_ = longest_motion_ = 0;
  neighbors_.begin_plan();
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
  return true;
}

/// Announces how far a block moves that turns, or strains, by so much: false when that is not finite.
template <int D>
bool Integrator<D>::plan_block(std::size_t i, const Vector<D>& velocity, double turn) {
  const double motion = duration_ * velocity.norm() + blocks_.radius[i] * turn;
  if (!std::isfinite(motion)) return false;
  neighbors_.plan(blocks_, i, motion);
  if (motion > blocks_.radius[i]) neighbors_.plan_way(i, duration_ * velocity);
  most_turned_ = std::max(most_turned_, turn);
  longest_motion_ = std::max(longest_motion_, motion);
  return true;
}

template <int D>
Vector<D> Integrator<D>::planned_way(std::size_t i) const {
  Vector<D> velocity = blocks_.velocity[i];
  if (blocks_.moves_freely(i)) velocity += 0.5 * duration_ * acceleration_[i];
  return duration_ * velocity;
}
template <int D>
Tensor<D> Integrator<D>::planned_stretch(std::size_t i) const {
  const Deformation<D>& deformation = blocks_.deformation(i);
  return duration_ * (deformation.rate + 0.5 * duration_ * deformation.acceleration);
}
template <int D>
Angular<D> Integrator<D>::planned_turn(std::size_t i) const {
  return next_rotation_[i].turn_since(blocks_.rotation[i]);
}

template <int D>
void Integrator<D>::kick_and_drift() {
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

template <int D>
Stock Integrator<D>::kick(double& applied_power) {
  const double half = 0.5 * duration_;
  Stock stock;
  applied_power = 0;
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
      kick_affine(i, stock, applied_power);
      continue;
    }
    take_stock(i, middle_velocity, middle_spin, stock);
  }
  return stock;
}

template class Integrator<2>;
template class Integrator<3>;

}  // namespace halfspace
