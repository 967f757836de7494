#include "world/motion/integrator.h"
#include "world/motion/local_damping.h"

// The integration of affine blocks: the gradient has a kick and a drift, as the centroid has.

namespace halfspace {

/// The force on the centroid, with that of the loads on the surface.
template <int D>
Vector<D> Integrator<D>::affine_load(std::size_t i) const {
  return load_on(i).force + blocks_.deformation(i).load_force;
}

template <int D>
Tensor<D> Integrator<D>::generalized_force(std::size_t i) const {
  const Deformation<D>& deformation = blocks_.deformation(i);
  const auto* target = model_.actions.target_of(i);
  if (!target) return deformation.drive(blocks_.applied_torque[i], model_.elasticity_of(i));
  return deformation.drive(blocks_.applied_torque[i] + target->torque, model_.elasticity_of(i)) +
         target->virial;
}

template <int D>
Tensor<D> Integrator<D>::strain_reaction(std::size_t i) const {
  if (reaction_.empty()) return Tensor<D>::Zero();
  return reaction_.rate() * reaction_.of_gradient(i) * blocks_.deformation(i).mass_matrix;
}

/// Newton's law for the centroid and for the gradient, with local damping against each component of their
/// rates and mass-proportional damping.
template <int D>
void Integrator<D>::accelerate_affine(std::size_t i) {
  Deformation<D>& deformation = blocks_.deformation(i);
  Vector<D> force = affine_load(i);
  Tensor<D> load_on = generalized_force(i);
  if (settings_.local_damping > 0) {
    const auto oppose = [&](double component, double velocity) {
      return damped(component, velocity, settings_.local_damping);
    };
    const Vector<D> reaction = this->reaction(i).force;
    const Tensor<D> strain_reaction = this->strain_reaction(i);
    force = (force + reaction).binaryExpr(blocks_.velocity[i], oppose).eval() - reaction;
    load_on = (load_on + strain_reaction).binaryExpr(deformation.rate, oppose).eval() - strain_reaction;
  }
  acceleration_[i] = force / blocks_.mass[i] - settings_.mass_damping * blocks_.velocity[i];
  deformation.acceleration =
      load_on * deformation.inverse_mass_matrix - settings_.mass_damping * deformation.rate;
}

/// False when the motion is not finite, or inverts or flattens the block.
template <int D>
bool Integrator<D>::predict_affine(std::size_t i, Prediction& prediction) {
  const double half = 0.5 * duration_;
  const Deformation<D>& deformation = blocks_.deformation(i);
  Vector<D> velocity = blocks_.velocity[i] + half * acceleration_[i];
  if (!kicks_.empty()) velocity += kicks_.of_block(i);
  const Tensor<D> change = predicted_stretch(i);
  const double strain = change.norm();
  if (strain <= max_turn) {
    const Tensor<D> next = deformation.gradient + change;
    if (!(next.determinant() > 0 && condition_of<D>(next) <= largest_condition)) return false;
  }
  return predict_block(i, velocity, strain, prediction);
}

/// First half of a step.
template <int D>
void Integrator<D>::kick_and_drift_affine(std::size_t i) {
  const double half = 0.5 * duration_;
  Deformation<D>& deformation = blocks_.deformation(i);
  blocks_.push(i, half * acceleration_[i], Angular<D>::Zero());
  deformation.rate += half * deformation.acceleration;
  if (!kicks_.empty()) {
    blocks_.push(i, kicks_.of_block(i), Angular<D>::Zero());
    deformation.rate += kicks_.of_gradient(i);
  }
  blocks_.drift_affine(std::int32_t(i), duration_ * blocks_.velocity[i], duration_);
}

/// As sample_energy(). `opposed_rate`: the rate for which damping was computed.
template <int D>
void Integrator<D>::sample_affine_energy(std::size_t i, const Vector<D>& opposed,
                                         const Tensor<D>& opposed_rate, EnergySample& sample) const {
  const Deformation<D>& deformation = blocks_.deformation(i);
  const Vector<D>& velocity = blocks_.velocity[i];
  const double mass = blocks_.mass[i];
  sample.squared_speed = std::max(sample.squared_speed, velocity.squaredNorm());
  const double radius = blocks_.radius[i];
  sample.squared_swing = std::max(sample.squared_swing, radius * radius * deformation.rate.squaredNorm());
  sample.kinetic += 0.5 * mass * velocity.squaredNorm() + deformation.kinetic_energy();
  sample.gravity -= mass * settings_.gravity.dot(blocks_.position[i]);
  sample.block_strain += deformation.strain_energy(model_.elasticity_of(i));
  // The power of a torque depends on the gradient, so it varies within a step.
  sample.power.outer += blocks_.applied_torque[i].dot(blocks_.spin[i]);
  sample.power.contact_damping += forces_.dashpot_power(i);
  sample.power.block_damping += deformation.damping_power(model_.elasticity_of(i), opposed_rate);
  if (settings_.local_damping > 0) {
    const Vector<D> force = affine_load(i) + reaction(i).force;
    const Tensor<D> strain_force = generalized_force(i) + strain_reaction(i);
    double power = 0;
    for (int k = 0; k < D; ++k) power += damped_power(force[k], opposed[k], velocity[k]);
    for (int k = 0; k < D * D; ++k)
      power += damped_power(strain_force(k), opposed_rate(k), deformation.rate(k));
    sample.power.local_damping += settings_.local_damping * power;
  }
  if (settings_.mass_damping > 0) {
    const double power = mass * opposed.dot(velocity) +
                         opposed_rate.cwiseProduct(deformation.rate * deformation.mass_matrix).sum();
    sample.power.mass_damping += settings_.mass_damping * power;
  }
}

/// Second half of a step.
template <int D>
void Integrator<D>::kick_affine(std::size_t i, EnergySample& sample) {
  const double half = 0.5 * duration_;
  const Deformation<D>& deformation = blocks_.deformation(i);
  const Vector<D> middle_velocity = blocks_.velocity[i];
  const Tensor<D> middle_rate = deformation.rate;
  accelerate_affine(i);
  sample.applied_power += blocks_.applied_force[i].dot(middle_velocity) +
                          deformation.load_force.dot(middle_velocity) +
                          deformation.load.cwiseProduct(middle_rate).sum();
  if (!model_.actions.empty()) {
    sample.applied_power += power_of_actions(i, middle_velocity, blocks_.spin[i]);
    if (const auto* target = model_.actions.target_of(i))
      sample.applied_power +=
          0.5 * (target->virial_at_start + target->virial).cwiseProduct(middle_rate).sum();
  }
  // A kick that is not finite is skipped, as for rigid blocks.
  if (acceleration_[i].allFinite() && deformation.acceleration.allFinite()) {
    blocks_.push(i, half * acceleration_[i], Angular<D>::Zero());
    blocks_.strain(i, half * deformation.acceleration);
    if (!(blocks_.velocity[i].allFinite() && deformation.rate.allFinite() && blocks_.spin[i].allFinite())) {
      blocks_.velocity[i] = middle_velocity;
      blocks_.deformation(i).rate = middle_rate;
      blocks_.strain(i, Tensor<D>::Zero());
    }
  }
  sample_affine_energy(i, middle_velocity, middle_rate, sample);
}

template <int D>
void Integrator<D>::take_affine_kick(std::size_t i, EnergySample& sample) {
  const double half = 0.5 * duration_;
  const Deformation<D>& deformation = blocks_.deformation(i);
  const Vector<D> middle_velocity = blocks_.velocity[i] - half * acceleration_[i];
  const Tensor<D> middle_rate = deformation.rate - half * deformation.acceleration;
  blocks_.push(i, kicks_.of_block(i), Angular<D>::Zero());
  blocks_.strain(i, kicks_.of_gradient(i));
  sample_affine_energy(i, middle_velocity, middle_rate, sample);
}

template class Integrator<2>;
template class Integrator<3>;

}  // namespace halfspace
