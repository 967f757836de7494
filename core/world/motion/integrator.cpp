#include "world/motion/integrator.h"

#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"
#include "world/motion/local_damping.h"

namespace halfspace {

/// Newton's law with local damping (Cundall's, against each component of the velocity) and mass-proportional
/// damping.
template <int D>
void Integrator<D>::accelerate_rigid(std::size_t i) {
  auto [force, torque] = load_on(i);
  if (settings_.local_damping > 0) {
    const BlockLoad by = reaction(i);
    for (int k = 0; k < D; ++k)
      force[k] =
          damped(force[k] + by.force[k], blocks_.velocity[i][k], settings_.local_damping) - by.force[k];
    for (int k = 0; k < torque.size(); ++k)
      torque[k] =
          damped(torque[k] + by.torque[k], blocks_.spin[i][k], settings_.local_damping) - by.torque[k];
  }
  acceleration_[i] = force / blocks_.mass[i] - settings_.mass_damping * blocks_.velocity[i];
  momentum_rate_[i] = torque - settings_.mass_damping * blocks_.momentum[i];
  if (blocks_.any_held()) {
    acceleration_[i] = blocks_.freed(i, acceleration_[i]);
    momentum_rate_[i] = blocks_.freed_turn(i, momentum_rate_[i]);
  }
}

template <int D>
void Integrator<D>::accelerate(std::size_t i) {
  blocks_.is_affine(i) ? accelerate_affine(i) : accelerate_rigid(i);
}

/// Adds a block's energies, and the powers of prescribed motion and of damping. `opposed`: the velocity for
/// which damping was computed. Forced inline, because a call would pass the sums through memory for each
/// block.
template <int D>
void Integrator<D>::sample_energy(std::size_t i, const Vector<D>& opposed, const Angular<D>& opposed_spin,
                                  EnergySample& sample) const {
  const Vector<D>& velocity = blocks_.velocity[i];
  const Angular<D>& spin = blocks_.spin[i];
  sample.power.contact_damping += forces_.dashpot_power(i);
  if (blocks_.kind[i] == BlockKind::prescribed) {
    sample.power.outer -= blocks_.force[i].dot(velocity) + blocks_.torque[i].dot(spin);
  }
  if (blocks_.kind[i] != BlockKind::rigid) return;
  const double mass = blocks_.mass[i];
  if (blocks_.any_held()) sample.power.outer += support_power(i, opposed);
  sample.squared_speed = std::max(sample.squared_speed, velocity.squaredNorm());
  const double radius = blocks_.radius[i];
  sample.squared_swing = std::max(sample.squared_swing, radius * radius * spin.squaredNorm());
  sample.kinetic += blocks_.kinetic_energy(std::int32_t(i));
  sample.gravity -= mass * settings_.gravity.dot(blocks_.position[i]);
  if (settings_.local_damping > 0) {
    const auto [force, torque] = load_on(i);
    const BlockLoad by = reaction(i);
    double power = 0;
    for (int k = 0; k < torque.size(); ++k)
      power += damped_power(torque[k] + by.torque[k], opposed_spin[k], spin[k]);
    for (int k = 0; k < D; ++k) power += damped_power(force[k] + by.force[k], opposed[k], velocity[k]);
    sample.power.local_damping += settings_.local_damping * power;
  }
  if (settings_.mass_damping > 0) {
    sample.power.mass_damping +=
        settings_.mass_damping * (mass * opposed.dot(velocity) + opposed_spin.dot(blocks_.momentum[i]));
  }
}

template <int D>
void Integrator<D>::look_what_moves() {
  blocks_.forget_motion();
  any_moves_.assign(chunk_count(blocks_.slot_count(), blocks_per_chunk), 0);
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) any_moves_[i / blocks_per_chunk] |= blocks_.moves(i);
}

template <int D>
EnergySample Integrator<D>::begin(double time_step, double& noise) {
  look_what_moves();
  EnergySample sample;
  double load_times_size = 0, rounding_energy = 0;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (blocks_.is_of_mesh(i) || blocks_.is_part(i)) continue;
    if (blocks_.kind[i] == BlockKind::prescribed) {
      acceleration_[i].setZero();
      momentum_rate_[i].setZero();
    }
    if (blocks_.moves_freely(i)) accelerate(i);
    if (share_.is_copy(i)) continue;  // its owner counts its energy
    if (blocks_.moves_freely(i)) {
      const double load = blocks_.mass[i] * settings_.gravity.norm() + blocks_.applied_force[i].norm();
      load_times_size += load * blocks_.radius[i] + blocks_.applied_torque[i].norm();
      const double reach = blocks_.position[i].norm() + blocks_.radius[i];
      const double speed = machine_epsilon * reach / time_step;
      rounding_energy += blocks_.mass[i] * speed * speed;
    }
    if (blocks_.is_affine(i)) {
      sample_affine_energy(i, blocks_.velocity[i], blocks_.deformation(i).rate, sample);
    } else {
      sample_energy(i, blocks_.velocity[i], blocks_.spin[i], sample);
    }
  }
  noise = load_times_size + rounding_energy;
  meshes_.begin(time_step, sample, noise);
  return sample;
}

template <int D>
Vector<D> Integrator<D>::acceleration_of(const MaterialPoint<D>& point) const {
  const std::size_t slot = std::size_t(point.block);
  if (blocks_.is_of_mesh(slot))
    return weighed(point, [&](std::size_t node) { return meshes_.acceleration_of(node); });
  if (blocks_.is_affine(slot))
    return acceleration_[slot] + blocks_.deformation(slot).acceleration * point.arm;
  if (blocks_.kind[slot] == BlockKind::prescribed)
    return acceleration_[slot] + swept(momentum_rate_[slot], point.arm);
  if (!blocks_.moves_freely(slot)) return Vector<D>::Zero();
  const std::size_t mover = blocks_.mover_of(slot);
  const Angular<D> rate = blocks_.inertia[mover].spin(momentum_rate_[mover], blocks_.rotation[mover]);
  return acceleration_[mover] + swept(rate, Vector<D>(point.arm + blocks_.arm_of(slot)));
}

template <int D>
void Integrator<D>::kick_and_drift() {
  const double half = 0.5 * duration_;
  const auto move = [&](std::size_t i) {
    if (blocks_.is_part(i) || share_.is_idle(i)) return;
    if (sleep_.is_asleep(i)) {
      blocks_.mean_spin[i].setZero();
      return;
    }
    if (blocks_.kind[i] == BlockKind::rigid) {
      blocks_.push(i, half * acceleration_[i], half * momentum_rate_[i]);
      if (!kicks_.empty()) blocks_.push(i, kicks_.of_block(i), kicks_.momentum(i));
    } else if (blocks_.is_affine(i)) {
      return kick_and_drift_affine(i);
    } else if (blocks_.kind[i] != BlockKind::prescribed) {
      return;
    } else if (!model_.actions.empty()) {
      blocks_.velocity[i] += half * acceleration_[i];
      blocks_.spin[i] += half * momentum_rate_[i];
    }
    blocks_.drift(std::int32_t(i), duration_ * blocks_.velocity[i], next_rotation_[i], duration_);
    if constexpr (D == 2) blocks_.angle[i] += duration_ * blocks_.spin[i][0];
  };
  for_each_chunk(threads_, blocks_.slot_count(), blocks_per_chunk, [&](const Chunk& chunk) {
    if (!any_moves_[chunk.index]) return;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) move(i);
  });
  for (const Part<D>& part : blocks_.compounds().parts()) {
    if (!blocks_.moves(std::size_t(part.compound))) continue;
    if (sleep_.is_asleep(std::size_t(part.compound))) {
      blocks_.mean_spin[std::size_t(part.block)].setZero();
    } else {
      follow_motion(part);
    }
  }
  meshes_.kick_and_drift(duration_);
}

/// A part moves with its compound. Until the kick its velocity is the mean one.
template <int D>
void Integrator<D>::follow_motion(const Part<D>& part) {
  const std::size_t p = std::size_t(part.block), c = std::size_t(part.compound);
  blocks_.follow(part);
  blocks_.mean_spin[p] = blocks_.mean_spin[c];
  const Angular<D> half_turn = 0.5 * duration_ * blocks_.mean_spin[c];
  const Vector<D> at_end = swept(blocks_.mean_spin[c], blocks_.arm_of(p));
  blocks_.velocity[p] =
      blocks_.velocity[c] + (at_end - swept(half_turn, at_end)) / (1 + half_turn.squaredNorm());
}

template <int D>
EnergySample Integrator<D>::kick() {
  sum_each_block(samples_, [&](std::size_t i, EnergySample& sample) {
    EnergySample of_copy;  // its owner counts it
    kick(i, share_.is_copy(i) ? of_copy : sample);
  });
  EnergySample all;
  for (const EnergySample& sample : samples_) all.add(sample);
  follow_velocities();
  meshes_.kick(duration_, all);
  return all;
}

template <int D>
void Integrator<D>::follow_velocities() {
  for (const Part<D>& part : blocks_.compounds().parts()) blocks_.follow_velocity(part);
}

/// Adds the velocity changes of contacts to the velocities, and samples the blocks' energy again.
template <int D>
void Integrator<D>::take_kicks(EnergySample& sample) {
  EnergySample all;
  all.applied_power = sample.applied_power;
  for (std::size_t i = 0; i < blocks_.moving_end(); ++i) take_kick(i, all);
  follow_velocities();
  meshes_.take_kicks(duration_, all);
  reaction_.swap(kicks_);
  sample = all;
}

template <int D>
void Integrator<D>::take_kick(std::size_t i, EnergySample& sample) {
  if (blocks_.is_of_mesh(i) || blocks_.is_part(i)) return;
  if (sleep_.is_asleep(i)) {
    if (!reaction_.empty()) kicks_.take_over(i, reaction_);  // it holds the block as before
    return kick_asleep(i, sample);
  }
  if (blocks_.is_affine(i)) return take_affine_kick(i, sample);
  Vector<D> middle_velocity = blocks_.velocity[i];
  const Angular<D> middle_spin = blocks_.spin[i];
  if (blocks_.kind[i] == BlockKind::rigid) {
    middle_velocity -= 0.5 * duration_ * acceleration_[i];
    blocks_.kick(i, kicks_.of_block(i), kicks_.momentum(i));
  }
  sample_energy(i, middle_velocity, middle_spin, sample);
}

/// A sleeping block keeps its energies, with no power.
template <int D>
void Integrator<D>::kick_asleep(std::size_t i, EnergySample& sample) const {
  EnergySample own;
  if (blocks_.is_affine(i)) {
    sample_affine_energy(i, blocks_.velocity[i], blocks_.deformation(i).rate, own);
  } else {
    sample_energy(i, blocks_.velocity[i], blocks_.spin[i], own);
  }
  own.power = {};
  sample.add(own);
}

template <int D>
SpeedBound Integrator<D>::speed_bound_of(std::size_t slot) const {
  const std::size_t i = blocks_.mover_of(slot);
  const double radius = blocks_.radius[i];
  SpeedBound pace{blocks_.velocity[i].norm() + blocks_.swing(i), acceleration_[i].norm()};
  if (blocks_.is_affine(i)) {
    pace.acceleration += radius * blocks_.deformation(i).acceleration.norm();
  } else if (blocks_.kind[i] == BlockKind::prescribed) {
    pace.acceleration += radius * momentum_rate_[i].norm();
  } else {
    pace.acceleration += radius * blocks_.inertia[i].spin(momentum_rate_[i], blocks_.rotation[i]).norm();
  }
  return pace;
}

template <int D>
SpeedBound Integrator<D>::speed_bound_with_impulses_of(std::size_t slot) const {
  const std::size_t i = blocks_.mover_of(slot);
  if (reaction_.empty() || blocks_.is_deformable(i)) return speed_bound_of(i);
  const BlockLoad by = reaction(i);
  const Angular<D> rate = momentum_rate_[i] + by.torque;
  return {blocks_.velocity[i].norm() + blocks_.swing(i),
          (acceleration_[i] + by.force / blocks_.mass[i]).norm() +
              blocks_.radius[i] * blocks_.inertia[i].spin(rate, blocks_.rotation[i]).norm()};
}

template <int D>
void Integrator<D>::kick(std::size_t i, EnergySample& sample) {
  if (blocks_.is_part(i) || share_.is_idle(i)) return;
  if (sleep_.is_asleep(i)) return kick_asleep(i, sample);
  if (blocks_.is_affine(i)) return kick_affine(i, sample);
  if (blocks_.is_of_mesh(i)) return;
  const double half = 0.5 * duration_;
  const Vector<D> middle_velocity = blocks_.velocity[i];
  const Angular<D> middle_spin = blocks_.spin[i];
  if (blocks_.kind[i] == BlockKind::rigid) {
    accelerate_rigid(i);
    sample.applied_power +=
        blocks_.applied_force[i].dot(middle_velocity) + blocks_.applied_torque[i].dot(middle_spin);
    if (!model_.actions.empty()) sample.applied_power += power_of_actions(i, middle_velocity, middle_spin);
    // A kick that is not finite is skipped: the next motion, predicted with it, is refused as unstable.
    const Angular<D> middle_momentum = blocks_.momentum[i];
    blocks_.kick(i, half * acceleration_[i], half * momentum_rate_[i]);
    if (!(blocks_.velocity[i].allFinite() && blocks_.spin[i].allFinite() &&
          blocks_.momentum[i].allFinite())) {
      blocks_.velocity[i] = middle_velocity;
      blocks_.spin[i] = middle_spin;
      blocks_.momentum[i] = middle_momentum;
    }
  }
  if (!model_.actions.empty()) give_velocity(i, sample);
  sample_energy(i, middle_velocity, middle_spin, sample);
}

#define HALFSPACE_MEMBERS(D)                                                          \
  template void Integrator<D>::accelerate(std::size_t);                               \
  template void Integrator<D>::look_what_moves();                                     \
  template EnergySample Integrator<D>::begin(double, double&);                        \
  template void Integrator<D>::follow_motion(const Part<D>&);                         \
  template void Integrator<D>::follow_velocities();                                   \
  template Vector<D> Integrator<D>::acceleration_of(const MaterialPoint<D>&) const;   \
  template void Integrator<D>::kick_and_drift();                                      \
  template EnergySample Integrator<D>::kick();                                        \
  template void Integrator<D>::take_kicks(EnergySample&);                             \
  template void Integrator<D>::take_kick(std::size_t, EnergySample&);                 \
  template void Integrator<D>::kick_asleep(std::size_t, EnergySample&) const;         \
  template SpeedBound Integrator<D>::speed_bound_of(std::size_t) const;               \
  template SpeedBound Integrator<D>::speed_bound_with_impulses_of(std::size_t) const; \
  template void Integrator<D>::kick(std::size_t, EnergySample&);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
