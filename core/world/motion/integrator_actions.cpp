#include "world/motion/integrator.h"
#include "world/motion/local_damping.h"

// Loads and motions in time, and held components: they are constant over each motion.

namespace halfspace {

/// The velocities that are given become accelerations of the first half, which lead to their means.
template <int D>
void Integrator<D>::take_actions(double duration) {
  const Actions<D>& actions = model_.actions;
  if (actions.accelerates_all()) {
    for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
      if (blocks_.moves_freely(i) && !blocks_.is_of_mesh(i) && !blocks_.is_part(i)) accelerate(i);
    }
  }
  const auto lead_to_mean = [&](const auto& given, auto& acceleration) {
    for (Eigen::Index k = 0; k < acceleration.size(); ++k) {
      if (given.is_given(k)) acceleration[k] = 2 / duration * (given.mean[k] - given.start[k]);
    }
  };
  for (const auto& target : actions.targets()) {
    const std::size_t i = std::size_t(target.slot);
    if (blocks_.moves_freely(i)) accelerate(i);
    lead_to_mean(target.velocity, acceleration_[i]);
    if (blocks_.kind[i] == BlockKind::prescribed) lead_to_mean(target.spin, momentum_rate_[i]);
  }
  meshes_.take_actions(duration);
}

template <int D>
double Integrator<D>::power_of_actions(std::size_t i, const Vector<D>& velocity,
                                       const Angular<D>& spin) const {
  double power = blocks_.mass[i] * model_.actions.acceleration().dot(velocity);
  if (const auto* target = model_.actions.target_of(i))
    power += target->force.dot(velocity) + 0.5 * (target->torque_at_start + target->torque).dot(spin);
  return power;
}

/// Blocks whose given velocities jump at the begin of the motion do work with the new ones.
template <int D>
double Integrator<D>::power_of_jumps() const {
  double power = meshes_.power_of_jumps();
  for (const auto& target : model_.actions.targets()) {
    const std::size_t i = std::size_t(target.slot);
    if (share_.is_copy(i)) continue;  // its owner counts its work
    if (blocks_.kind[i] == BlockKind::prescribed) {
      power -= target.velocity.power_of_jump(blocks_.force[i]) + target.spin.power_of_jump(blocks_.torque[i]);
    } else {
      power -= target.velocity.power_of_jump(load_on(i).force + reaction(i).force);
    }
  }
  return power;
}

/// The support of a held component also does the work of its change of velocity.
template <int D>
void Integrator<D>::give_velocity(std::size_t i, EnergySample& sample) {
  const auto* target = model_.actions.target_of(i);
  if (!target) return;
  const auto give = [](const auto& given, auto& velocity) {
    for (Eigen::Index k = 0; k < velocity.size(); ++k) {
      if (given.is_given(k)) velocity[k] = given.end[k];
    }
  };
  give(target->velocity, blocks_.velocity[i]);
  if (blocks_.kind[i] == BlockKind::prescribed) return give(target->spin, blocks_.spin[i]);
  double work = 0;
  for (int k = 0; k < D; ++k) {
    const double start = target->velocity.start[k], end = target->velocity.end[k];
    if (target->velocity.is_given(k)) work += 0.5 * blocks_.mass[i] * (end * end - start * start);
  }
  sample.applied_power += work / duration_;
}

/// The power of the supports of held components, which balance all other forces along them.
template <int D>
double Integrator<D>::support_power(std::size_t i, const Vector<D>& opposed) const {
  const Vector<D> force = load_on(i).force, by = reaction(i).force;
  double power = 0;
  for (int k = 0; k < D; ++k) {
    if (!blocks_.is_held(i, k)) continue;
    const double damping = settings_.mass_damping * blocks_.mass[i] * opposed[k];
    const double rest = damped(force[k] + by[k], opposed[k], settings_.local_damping) - by[k] - damping;
    power -= rest * blocks_.velocity[i][k];
  }
  return power;
}

#define HALFSPACE_MEMBERS(D)                                                                               \
  template void Integrator<D>::take_actions(double);                                                       \
  template double Integrator<D>::power_of_actions(std::size_t, const Vector<D>&, const Angular<D>&) const; \
  template double Integrator<D>::power_of_jumps() const;                                                   \
  template void Integrator<D>::give_velocity(std::size_t, EnergySample&);                                  \
  template double Integrator<D>::support_power(std::size_t, const Vector<D>&) const;

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
