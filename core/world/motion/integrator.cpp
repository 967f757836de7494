#include "world/motion/integrator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "block/free_turn.h"
#include "world/motion/local_damping.h"

namespace halfspace {

template <int D>
typename Integrator<D>::BlockLoad Integrator<D>::load_on(std::size_t i) const {
  BlockLoad load{blocks_.force[i] + blocks_.applied_force[i] + blocks_.mass[i] * settings_.gravity,
                 blocks_.torque[i] + blocks_.applied_torque[i]};
  if (!model_.actions.empty()) {
    load.force += blocks_.mass[i] * model_.actions.acceleration();
    if (const auto* target = model_.actions.target_of(i)) {
      load.force += target->force;
      load.torque += target->torque;
    }
  }
  return load;
}

template <int D>
typename Integrator<D>::BlockLoad Integrator<D>::reaction(std::size_t i) const {
  if (reaction_.empty()) return {Vector<D>::Zero(), Angular<D>::Zero()};
  const double rate = reaction_.rate();
  return {rate * blocks_.mass[i] * reaction_.of_block(i), rate * reaction_.momentum(i)};
}

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
[[gnu::always_inline]] inline void Integrator<D>::sample_energy(std::size_t i, const Vector<D>& opposed,
                                                                const Angular<D>& opposed_spin,
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
  any_moves_.assign(chunk_count(blocks_.slot_count(), blocks_per_chunk), 0);
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) any_moves_[i / blocks_per_chunk] |= blocks_.moves(i);
}

template <int D>
EnergySample Integrator<D>::begin(double time_step, double& noise) {
  look_what_moves();
  EnergySample sample;
  double weight_times_size = 0, rounding_energy = 0;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (blocks_.is_of_mesh(i) || blocks_.is_part(i)) continue;
    if (blocks_.kind[i] == BlockKind::prescribed) {
      acceleration_[i].setZero();
      momentum_rate_[i].setZero();
    }
    if (blocks_.moves_freely(i)) {
      accelerate(i);
      weight_times_size += blocks_.mass[i] * settings_.gravity.norm() * blocks_.radius[i];
      const double reach = blocks_.position[i].norm() + blocks_.radius[i];
      const double speed = std::numeric_limits<double>::epsilon() * reach / time_step;
      rounding_energy += blocks_.mass[i] * speed * speed;
    }
    if (blocks_.is_affine(i)) {
      sample_affine_energy(i, blocks_.velocity[i], blocks_.deformation(i).rate, sample);
    } else {
      sample_energy(i, blocks_.velocity[i], blocks_.spin[i], sample);
    }
  }
  noise = weight_times_size + rounding_energy;
  meshes_.begin(time_step, sample, noise);
  return sample;
}

template <int D>
template <class Sums, class Visit>
void Integrator<D>::sum_each_block(Sums& sums, Visit visit) {
  sum_each_chunk(threads_, blocks_.slot_count(), blocks_per_chunk, sums, [&](const Chunk& chunk, auto& sum) {
    if (!any_moves_[chunk.index]) return;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) visit(i, sum);
  });
}

template <int D>
bool Integrator<D>::predict(double duration) {
  duration_ = duration;
  const std::size_t slots = blocks_.slot_count();
  next_rotation_.resize(slots);
  samples_.reserve(chunk_count(slots, blocks_per_chunk));
  if (!meshes_.predict(duration)) return false;
  sum_each_block(planned_, [&](std::size_t i, Plan& plan) {
    plan.is_valid = plan.is_valid && predict_motion_of(i, plan);
  });
  Plan all;
  for (const Plan& plan : planned_) {
    if (!plan.is_valid) return false;
    all.needs_rebuild |= plan.needs_rebuild;
    all.goes_far |= plan.goes_far;
    all.longest_motion = std::max(all.longest_motion, plan.longest_motion);
    all.max_rotation = std::max(all.max_rotation, plan.max_rotation);
  }
  if (!predict_parts(all)) return false;
  longest_motion_ = all.longest_motion;
  max_rotation_ = all.max_rotation;
  neighbors_.end_announcements(all.needs_rebuild);
  if (all.goes_far && kicks_.empty()) announce_displacements();  // impulses may still change the direction
  return true;
}

template <int D>
bool Integrator<D>::predict_motion_of(std::size_t i, Plan& plan) {
  if (blocks_.is_part(i)) return true;  // follows its compound
  if (sleep_.is_asleep(i)) {
    next_rotation_[i] = blocks_.rotation[i];
    return predict_block(i, Vector<D>::Zero(), 0, plan);
  }
  const double half = 0.5 * duration_;
  Vector<D> velocity = blocks_.velocity[i];
  Angular<D> spin = blocks_.spin[i];
  switch (blocks_.kind[i]) {
    case BlockKind::affine:
      return predict_affine(i, plan);
    case BlockKind::mesh:
      return predict_block(i, meshes_.predicted_displacement(i) / duration_,
                           meshes_.predicted_stretch(i).norm(), plan);
    case BlockKind::rigid: {
      velocity += half * acceleration_[i];
      Angular<D> momentum = blocks_.momentum[i] + half * momentum_rate_[i];
      if (!kicks_.empty()) {
        velocity += kicks_.of_block(i);
        momentum += kicks_.momentum(i);
      }
      const auto onward = turned_freely(blocks_.rotation[i], blocks_.inertia[i], momentum, duration_);
      spin = onward.spin;
      next_rotation_[i] = onward.rotation;
      break;
    }
    case BlockKind::prescribed:
      velocity += half * acceleration_[i];
      spin += half * momentum_rate_[i];
      next_rotation_[i] = blocks_.rotation[i].turned_by(duration_ * spin);
      break;
    default:
      return true;
  }
  const double turn = std::max(duration_ * spin.norm(), next_rotation_[i].farthest_from(blocks_.rotation[i]));
  return predict_block(i, velocity, turn, plan);
}

/// Parts move with their compounds, whose motion has been predicted.
template <int D>
bool Integrator<D>::predict_parts(Plan& plan) {
  for (const Part<D>& part : blocks_.compounds().parts()) {
    const std::size_t p = std::size_t(part.block), c = std::size_t(part.compound);
    if (!blocks_.moves(c)) continue;
    next_rotation_[p] = next_rotation_[c] * part.pose.rotation;
    const double turn =
        std::max(predicted_turn(c).norm(), next_rotation_[c].farthest_from(blocks_.rotation[c]));
    if (!predict_block(p, predicted_displacement(p) / duration_, turn, plan)) return false;
  }
  return true;
}

/// Announces the maximum displacement of a block. `turn`: its rotation or change of gradient. False when not
/// finite.
template <int D>
bool Integrator<D>::predict_block(std::size_t i, const Vector<D>& velocity, double turn, Plan& plan) {
  const double motion = duration_ * velocity.norm() + blocks_.radius[i] * turn;
  if (!std::isfinite(motion)) return false;
  if (!blocks_.is_compound(i)) plan.needs_rebuild |= neighbors_.announce(blocks_, i, motion);
  plan.goes_far |= motion > blocks_.radius[i];
  plan.max_rotation = std::max(plan.max_rotation, turn);
  plan.longest_motion = std::max(plan.longest_motion, motion);
  return true;
}

/// Announces the displacements of blocks that move by more than their radius.
template <int D>
void Integrator<D>::announce_displacements() {
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (blocks_.moves(i) && !blocks_.is_compound(i) && neighbors_.announced_motion(i) > blocks_.radius[i])
      neighbors_.announce_displacement(i, predicted_displacement(i));
  }
}

template <int D>
Vector<D> Integrator<D>::predicted_displacement(std::size_t i) const {
  if (blocks_.is_of_mesh(i)) return meshes_.predicted_displacement(i);
  if (sleep_.is_asleep(i)) return Vector<D>::Zero();
  if (blocks_.is_part(i)) return predicted_displacement_of_part(i);
  Vector<D> velocity = blocks_.velocity[i];
  if (blocks_.moves(i)) velocity += 0.5 * duration_ * acceleration_[i];
  if (blocks_.moves_freely(i) && !kicks_.empty()) velocity += kicks_.of_block(i);
  return duration_ * velocity;
}
template <int D>
Vector<D> Integrator<D>::predicted_displacement_of_part(std::size_t i) const {
  const Part<D>& part = blocks_.compounds().part_of_block(i);
  const std::size_t compound = std::size_t(part.compound);
  return predicted_displacement(compound) + next_rotation_[compound] * part.pose.position - blocks_.arm_of(i);
}
template <int D>
Tensor<D> Integrator<D>::predicted_stretch(std::size_t i) const {
  if (blocks_.is_of_mesh(i)) return meshes_.predicted_stretch(i);
  if (sleep_.is_asleep(i)) return Tensor<D>::Zero();
  const Deformation<D>& deformation = blocks_.deformation(i);
  Tensor<D> rate = deformation.rate + 0.5 * duration_ * deformation.acceleration;
  if (!kicks_.empty()) rate += kicks_.of_gradient(i);
  return duration_ * rate;
}
template <int D>
Angular<D> Integrator<D>::predicted_turn(std::size_t i) const {
  return next_rotation_[i].turn_since(blocks_.rotation[i]);
}

template <int D>
Vector<D> Integrator<D>::predicted_velocity(const MaterialPoint<D>& point) const {
  const std::size_t slot = std::size_t(point.block);
  Vector<D> way = Vector<D>::Zero();
  if (blocks_.is_of_mesh(slot)) {
    way = weighed(point, [&](std::size_t node) { return predicted_displacement_of_node(node); });
  } else if (blocks_.is_affine(slot)) {
    way = predicted_displacement(slot) + predicted_stretch(slot) * point.arm;
  } else if (blocks_.moves(slot)) {
    const Vector<D> own = blocks_.rotation[slot].inverse() * point.arm;
    way = predicted_displacement(slot) + next_rotation_[slot] * own - point.arm;
  }
  return way / duration_;
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
    if (sleep_.is_asleep(i) || blocks_.is_part(i)) return;
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
    blocks_.drift(std::int32_t(i), duration_ * blocks_.velocity[i], next_rotation_[i]);
    if constexpr (D == 2) blocks_.angle[i] += duration_ * blocks_.spin[i][0];
  };
  for_each_chunk(threads_, blocks_.slot_count(), blocks_per_chunk, [&](const Chunk& chunk) {
    if (!any_moves_[chunk.index]) return;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) move(i);
  });
  for (const Part<D>& part : blocks_.compounds().parts()) {
    if (blocks_.moves(std::size_t(part.compound)) && !sleep_.is_asleep(std::size_t(part.compound)))
      blocks_.follow(part);
  }
  meshes_.kick_and_drift(duration_);
}

template <int D>
EnergySample Integrator<D>::kick() {
  sum_each_block(samples_, [&](std::size_t i, EnergySample& sample) { kick(i, sample); });
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
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) take_kick(i, all);
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
  if (blocks_.is_part(i)) return;
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

#define HALFSPACE_MEMBERS(D)                                                                   \
  template typename Integrator<D>::BlockLoad Integrator<D>::load_on(std::size_t) const;        \
  template typename Integrator<D>::BlockLoad Integrator<D>::reaction(std::size_t) const;       \
  template void Integrator<D>::accelerate_rigid(std::size_t);                                  \
  template void Integrator<D>::accelerate(std::size_t);                                        \
  template void Integrator<D>::sample_energy(std::size_t, const Vector<D>&, const Angular<D>&, \
                                             EnergySample&) const;                             \
  template void Integrator<D>::look_what_moves();                                              \
  template EnergySample Integrator<D>::begin(double, double&);                                 \
  template bool Integrator<D>::predict(double);                                                \
  template bool Integrator<D>::predict_motion_of(std::size_t, Plan&);                          \
  template bool Integrator<D>::predict_block(std::size_t, const Vector<D>&, double, Plan&);    \
  template void Integrator<D>::announce_displacements();                                       \
  template bool Integrator<D>::predict_parts(Plan&);                                           \
  template Vector<D> Integrator<D>::predicted_displacement_of_part(std::size_t) const;         \
  template void Integrator<D>::follow_velocities();                                            \
  template Vector<D> Integrator<D>::predicted_displacement(std::size_t) const;                 \
  template Tensor<D> Integrator<D>::predicted_stretch(std::size_t) const;                      \
  template Angular<D> Integrator<D>::predicted_turn(std::size_t) const;                        \
  template Vector<D> Integrator<D>::predicted_velocity(const MaterialPoint<D>&) const;         \
  template Vector<D> Integrator<D>::acceleration_of(const MaterialPoint<D>&) const;            \
  template void Integrator<D>::kick_and_drift();                                               \
  template EnergySample Integrator<D>::kick();                                                 \
  template void Integrator<D>::take_kicks(EnergySample&);                                      \
  template void Integrator<D>::take_kick(std::size_t, EnergySample&);                          \
  template void Integrator<D>::kick_asleep(std::size_t, EnergySample&) const;                  \
  template SpeedBound Integrator<D>::speed_bound_of(std::size_t) const;                        \
  template SpeedBound Integrator<D>::speed_bound_with_impulses_of(std::size_t) const;          \
  template void Integrator<D>::kick(std::size_t, EnergySample&);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
