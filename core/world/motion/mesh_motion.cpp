#include "world/motion/mesh_motion.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"
#include "world/motion/local_damping.h"

namespace halfspace {

/// Sums all forces on the nodes: gravity and applied forces, then elements and contacts in ascending order.
/// Returns the strain energy.
template <int D>
double MeshMotion<D>::evaluate_forces() {
  for_each_node([&](std::size_t i) {
    meshes_.force[i] = meshes_.mass[i] * settings_.gravity + meshes_.applied_force[i];
  });
  const ElementSums elements = elements_.load_nodes();
  largest_strain_ = elements.squared_strain;
  load_nodes_at_surface();
  return elements.amount;
}

template <int D>
void MeshMotion<D>::load_nodes_at_surface() {
  const Array<SurfaceCell<D>>& surface = meshes_.surface();
  surface_loads_.resize(surface.size());
  for_each_surface_cell([&](std::size_t c) { surface_loads_[c] = load_of(surface[c]); });
  for (std::size_t c = 0; c < surface.size(); ++c) {
    for (int i = 0; i <= D; ++i)
      meshes_.force[std::size_t(surface[c].node[std::size_t(i)])] += surface_loads_[c].col(i);
    const Tensor<D> strain = model_.blocks.deformation(std::size_t(surface[c].block)).strain();
    largest_strain_ = std::max(largest_strain_, strain.squaredNorm());
  }
}

/// Nodal forces with the same work as the cell's contacts, because a simplex has an affine displacement
/// field.
template <int D>
typename MeshMotion<D>::CornerLoads MeshMotion<D>::load_of(const SurfaceCell<D>& cell) const {
  const std::size_t block = std::size_t(cell.block);
  const Blocks<D>& blocks = model_.blocks;
  const Vector<D> share = blocks.force[block] / (D + 1);
  const Deformation<D>& deformation = blocks.deformation(block);
  const Tensor<D> in_frame = deformation.virial * deformation.gradient.inverse().transpose();
  CornerLoads loads;
  for (int i = 0; i <= D; ++i) loads.col(i) = share + in_frame * cell.gradients.col(i);
  return loads;
}

/// Newton's law with local and mass-proportional damping, for the components that are not held.
template <int D>
void MeshMotion<D>::accelerate(std::size_t i, double to_end) {
  const Vector<D>& velocity = meshes_.velocity[i];
  const Vector<D> reaction = this->reaction(i), acting = force_on(i);
  for (int k = 0; k < D; ++k) {
    const double force = damped(acting[k] + reaction[k], velocity[k], settings_.local_damping) - reaction[k];
    acceleration_[i][k] = is_held(i, k) ? 0 : force / meshes_.mass[i] - settings_.mass_damping * velocity[k];
  }
  if (!model_.viscous_nodes.empty()) damp_by_ground(i, to_end);
}

/// A dashpot acts by the velocity at the end of the motion: so it limits no time step.
template <int D>
void MeshMotion<D>::damp_by_ground(std::size_t i, double to_end) {
  const Tensor<D>* viscosity = model_.viscous_nodes.viscosity_of(i);
  if (!viscosity) return;
  Tensor<D> resistance = meshes_.mass[i] * Tensor<D>::Identity() + to_end * *viscosity;
  Vector<D> force = meshes_.mass[i] * acceleration_[i] - *viscosity * meshes_.velocity[i];
  for (int k = 0; k < D; ++k) {
    if (!is_held(i, k)) continue;
    resistance.row(k).setZero();
    resistance.col(k).setZero();
    resistance(k, k) = 1;
    force[k] = 0;
  }
  const Vector<D> acceleration = resistance.inverse() * force;
  for (int k = 0; k < D; ++k) {
    if (!is_held(i, k)) acceleration_[i][k] = acceleration[k];
  }
}

/// The power that the dashpot of a node takes up. Along held axes the supports balance it.
template <int D>
double MeshMotion<D>::power_of_ground(std::size_t i, const Tensor<D>& viscosity) const {
  const Vector<D> force = viscosity * meshes_.velocity[i];
  double power = 0;
  for (int k = 0; k < D; ++k) {
    if (!is_held(i, k)) power += force[k] * meshes_.velocity[i][k];
  }
  return power;
}

/// Adds a node's kinetic energy, and the powers of its supports and of damping. `opposed`: the velocity for
/// which damping was computed.
template <int D>
void MeshMotion<D>::sample_energy(std::size_t i, const Vector<D>& opposed, EnergySample& sample) const {
  const Vector<D>& velocity = meshes_.velocity[i];
  const double mass = meshes_.mass[i];
  const Vector<D> acting = force_on(i), force = acting + reaction(i);
  sample.squared_speed = std::max(sample.squared_speed, velocity.squaredNorm());
  sample.kinetic += 0.5 * mass * velocity.squaredNorm();
  if (!model_.viscous_nodes.empty()) {
    if (const Tensor<D>* viscosity = model_.viscous_nodes.viscosity_of(i))
      sample.power.outer -= power_of_ground(i, *viscosity);
  }
  for (int k = 0; k < D; ++k) {
    if (is_held(i, k)) {
      sample.power.outer -= acting[k] * velocity[k];
    } else {
      sample.power.local_damping += settings_.local_damping * damped_power(force[k], opposed[k], velocity[k]);
      sample.power.mass_damping += settings_.mass_damping * mass * opposed[k] * velocity[k];
    }
  }
}

template <int D>
void MeshMotion<D>::take_surface_stock(EnergySample& sample) const {
  const Blocks<D>& blocks = model_.blocks;
  for (const SurfaceCell<D>& cell : meshes_.surface()) {
    const std::size_t block = std::size_t(cell.block);
    const double radius = blocks.radius[block];
    sample.squared_swing =
        std::max(sample.squared_swing, radius * radius * blocks.deformation(block).rate.squaredNorm());
    sample.power.contact_damping += forces_.dashpot_power(block);
  }
}

template <int D>
void MeshMotion<D>::begin(double time_step, EnergySample& sample, double& noise) {
  if (meshes_.empty()) return;
  sample.block_strain += evaluate_forces();
  for (const Body<D>& body : meshes_.bodies()) {
    for (std::size_t i = std::size_t(body.first_node); i < std::size_t(body.first_node + body.node_count);
         ++i) {
      accelerate(i, 0);
      const Vector<D> position = body.origin + meshes_.place[i];
      const double speed = machine_epsilon * position.norm() / time_step;
      noise += meshes_.mass[i] * (speed * speed + settings_.gravity.norm() * meshes_.place[i].norm());
      sample.gravity -= meshes_.mass[i] * settings_.gravity.dot(position);
      sample_energy(i, meshes_.velocity[i], sample);
    }
  }
  take_surface_stock(sample);
  sample.power.block_damping += elements_.damping_power(0, acceleration_, nullptr);
}

/// A translation of a body strains no cell, except by rounding of positions relative to the body's origin.
template <int D>
typename MeshMotion<D>::Bending MeshMotion<D>::max_bending() const {
  Bending most;
  for (const Body<D>& body : meshes_.bodies()) {
    const std::size_t first = std::size_t(body.first_node), last = first + std::size_t(body.node_count);
    if (first == last) continue;
    const Vector<D> common = predicted_displacement_of_node(first);
    double aside = 0, reach = 0;
    for (std::size_t i = first; i < last; ++i) {
      const Vector<D> way = predicted_displacement_of_node(i);
      if (!way.allFinite()) return {HUGE_VAL, HUGE_VAL};
      aside = std::max(aside, (way - common).squaredNorm());
      reach = std::max(reach, (meshes_.place[i] + way).squaredNorm());
    }
    most.by_motion = std::max(most.by_motion, body.steepest * std::sqrt(aside));
    most.by_rounding = std::max(most.by_rounding, body.steepest * std::sqrt(reach));
  }
  most.by_rounding *= machine_epsilon;
  return most;
}

/// True when the predicted motion inverts no cell and flattens no surface block.
template <int D>
bool MeshMotion<D>::keeps_upright() {
  const auto check = [&](const auto& cell, const auto& gradients) {
    Tensor<D> next = Tensor<D>::Zero();
    for (std::size_t i = 0; i < cell.node.size(); ++i) {
      const std::size_t node = std::size_t(cell.node[i]);
      next += (meshes_.place[node] + predicted_displacement_of_node(node)) *
              gradients.col(Eigen::Index(i)).transpose();
    }
    if (inverted_.body < 0 && !(next.determinant() > 0 && condition_of<D>(next) <= largest_condition))
      inverted_ = {cell.body, cell.cell};
  };
  meshes_.for_each_element([&](const auto& element) { check(element, element.gradients); });
  for (const SurfaceCell<D>& cell : meshes_.surface()) check(cell, cell.gradients);
  return inverted_.body < 0;
}

/// No cell is inverted if the motion changes the gradient by less than its minimum stretch, which is at least
/// sqrt(1 - 2 |E|). So only violent motions require a test of each cell.
template <int D>
bool MeshMotion<D>::predict(double duration) {
  duration_ = duration;
  inverted_ = {};
  if (meshes_.empty()) return true;
  const Bending bent = max_bending();
  if (!std::isfinite(bent.by_motion) || !(bent.by_rounding <= rounded_strain)) return false;
  const double min_stretch = std::sqrt(std::max(1 - 2 * std::sqrt(largest_strain_), 0.0));
  return bent.by_motion < 0.5 * min_stretch || keeps_upright();
}

template <int D>
void MeshMotion<D>::take_actions(double duration) {
  if (meshes_.empty()) return;
  for (std::size_t i = 0; i < meshes_.node_count(); ++i) accelerate(i, 0);
  model_.actions.for_each_given_node(meshes_, [&](std::size_t i, const GivenVelocity<Vector<D>>& given) {
    for (int k = 0; k < D; ++k) {
      if (given.is_given(k)) acceleration_[i][k] = 2 / duration * (given.mean[k] - given.start[k]);
    }
  });
}

/// Supports whose velocities jump at the begin of the motion act with the new ones.
template <int D>
double MeshMotion<D>::power_of_jumps() const {
  double power = 0;
  model_.actions.for_each_given_node(meshes_, [&](std::size_t i, const GivenVelocity<Vector<D>>& given) {
    power -= given.power_of_jump(force_on(i) + reaction(i));
  });
  return power;
}

/// At the end of the motion. The supports also do the work of the change of velocity.
template <int D>
void MeshMotion<D>::give_velocities(EnergySample& sample) {
  model_.actions.for_each_given_node(meshes_, [&](std::size_t i, const GivenVelocity<Vector<D>>& given) {
    double work = 0;
    for (int k = 0; k < D; ++k) {
      if (!given.is_given(k)) continue;
      meshes_.velocity[i][k] = given.end[k];
      work += 0.5 * meshes_.mass[i] * (given.end[k] * given.end[k] - given.start[k] * given.start[k]);
    }
    sample.applied_power += work / duration_;
  });
}

template <int D>
Vector<D> MeshMotion<D>::predicted_displacement(std::size_t block) const {
  Vector<D> sum = Vector<D>::Zero();
  for (const std::int32_t i : meshes_.surface_of_block(block).node)
    sum += predicted_displacement_of_node(std::size_t(i));
  return sum / (D + 1);
}

template <int D>
Tensor<D> MeshMotion<D>::predicted_stretch(std::size_t block) const {
  const SurfaceCell<D>& cell = meshes_.surface_of_block(block);
  Tensor<D> sum = Tensor<D>::Zero();
  for (int i = 0; i <= D; ++i)
    sum += predicted_displacement_of_node(std::size_t(cell.node[std::size_t(i)])) *
           cell.gradients.col(i).transpose();
  return sum;
}

template <int D>
void MeshMotion<D>::kick_and_drift(double duration) {
  for_each_node([&](std::size_t i) {
    meshes_.velocity[i] += 0.5 * duration * acceleration_[i];
    if (!kicks_.empty()) meshes_.velocity[i] += kicks_.of_node(i);
    meshes_.place[i] += duration * meshes_.velocity[i];
  });
  for_each_surface_cell([&](std::size_t c) { model_.blocks.follow_nodes(meshes_.surface()[c], duration); });
}

template <int D>
void MeshMotion<D>::kick(double duration, EnergySample& sample) {
  if (meshes_.empty()) return;
  strain_energy_ = evaluate_forces();
  sample.block_strain += strain_energy_;
  if (!model_.actions.empty()) give_velocities(sample);
  sum_each_node(sample, [&](std::size_t i, const Body<D>& body, EnergySample& sum) {
    const Vector<D> middle_velocity = meshes_.velocity[i];
    accelerate(i, 0.5 * duration);
    sum.applied_power += meshes_.applied_force[i].dot(middle_velocity);
    if (!model_.actions.empty()) sum.applied_power += load_of_actions(i).dot(middle_velocity);
    // A kick that is not finite is skipped, as for rigid blocks.
    const Vector<D> velocity = middle_velocity + 0.5 * duration * acceleration_[i];
    if (velocity.allFinite()) meshes_.velocity[i] = velocity;
    sum.gravity -= meshes_.mass[i] * settings_.gravity.dot(body.origin + meshes_.place[i]);
    sample_energy(i, middle_velocity, sum);
  });
  end_kick(duration, nullptr, sample);
}

template <int D>
void MeshMotion<D>::take_kicks(double duration, EnergySample& sample) {
  if (meshes_.empty()) return;
  sample.block_strain += strain_energy_;
  sum_each_node(sample, [&](std::size_t i, const Body<D>& body, EnergySample& sum) {
    const Vector<D> middle_velocity = meshes_.velocity[i] - 0.5 * duration * acceleration_[i];
    meshes_.velocity[i] += kicks_.of_node(i);
    sum.gravity -= meshes_.mass[i] * settings_.gravity.dot(body.origin + meshes_.place[i]);
    sample_energy(i, middle_velocity, sum);
  });
  end_kick(duration, &kicks_, sample);
}

/// Surface blocks take over the velocities of their nodes.
template <int D>
void MeshMotion<D>::end_kick(double duration, const VelocityChange<D>* kicks, EnergySample& sample) {
  for_each_surface_cell([&](std::size_t c) { model_.blocks.follow_node_velocities(meshes_.surface()[c]); });
  take_surface_stock(sample);
  const auto is_damped = [](const Body<D>& body) { return body.damping_time > 0; };
  if (std::any_of(meshes_.bodies().begin(), meshes_.bodies().end(), is_damped))
    sample.power.block_damping += elements_.damping_power(0.5 * duration, acceleration_, kicks);
}

template class MeshMotion<2>;
template class MeshMotion<3>;

}  // namespace halfspace
