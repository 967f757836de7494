#include <algorithm>
#include <cmath>

#include "world/world.h"

namespace halfspace {

/// Stiffness of the stiffest contact that a block can have.
template <int D>
double World<D>::stiffness_on(std::size_t slot) const {
  double stiffest = 0;
  for (std::int32_t other = 0; other < material_count(); ++other) {
    const SpringLaw& law = laws_.between(blocks_.material[slot], other);
    const double spring = std::max(law.normal_stiffness, law.shear_stiffness);
    const bool per_area = law.stiffness_kind == StiffnessKind::per_area;
    stiffest = std::max(stiffest, per_area ? spring * blocks_.longest_edge[slot] : spring);
  }
  return stiffest;
}

/// Gershgorin: no frequency exceeds omega^2 = 2 sum_contacts K (1/m + r^2/I), with r at most the block's radius. Central differences
/// are stable up to 2/omega. Blocks will meet others: never fewer than four contacts are counted.
template <int D>
double World<D>::stable_time_step() const {
  constexpr int least_contacts = 4;
  Array<std::int32_t> contacts_of(blocks_.slot_count(), 0, density_.get_allocator());
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    ++contacts_of[std::size_t(candidate_of(c).a)];
    ++contacts_of[std::size_t(candidate_of(c).b)];
  }
  double largest = 0;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (blocks_.kind[i] != BlockKind::rigid) continue;
    const double contacts = std::max(contacts_of[i], least_contacts);
    const double mobility = 1 / blocks_.mass[i] + blocks_.radius[i] * blocks_.radius[i] / blocks_.inertia[i];
    largest = std::max(largest, 2 * contacts * stiffness_on(i) * mobility);
  }
  return 2 / std::sqrt(largest);
}

template <int D>
bool World<D>::choose_time_step() {
  const double now = time();
  double chosen = settings_.time_step;
  if (chosen == 0) {
    detect();  // the contacts that are there count
    chosen = settings_.safety * stable_time_step();
  }
  if (!std::isfinite(chosen) || chosen <= 0) return false;
  if (chosen == time_step_) return true;
  epoch_time_ = now;
  epoch_step_ = steps_;
  time_step_ = chosen;
  return true;
}

/// Accelerations and energies of the present state; what an edit has done to the energy is outer work.
template <int D>
void World<D>::start_ledger() {
  acceleration_.resize(blocks_.slot_count(), Vector<D>::Zero());
  angular_acceleration_.resize(blocks_.slot_count());
  ledger_.kinetic = ledger_.gravity = 0;
  prescribed_power_ = 0;
  double weight_times_size = 0;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (blocks_.kind[i] == BlockKind::prescribed) {
      prescribed_power_ -= blocks_.force[i].dot(blocks_.velocity[i]) + blocks_.torque[i] * blocks_.spin[i];
    }
    if (blocks_.kind[i] != BlockKind::rigid) continue;
    accelerate(i);
    ledger_.kinetic += blocks_.kinetic_energy(std::int32_t(i));
    ledger_.gravity -= blocks_.mass[i] * settings_.gravity.dot(blocks_.position[i]);
    weight_times_size += blocks_.mass[i] * settings_.gravity.norm() * blocks_.radius[i];
  }
  noise_energy_ = weight_times_size + ledger_.kinetic + ledger_.strain;
  ledger_.outer_work = ledger_.total() - residual_before_edit_;
}

template class World<2>;

}  // namespace halfspace
