#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/world.h"

namespace halfspace {
namespace {

/// The largest area, in the plane the largest width, that blocks of this radius can share.
template <int D>
double largest_base(double radius) {
  return D == 2 ? 2 * radius : std::numbers::pi * radius * radius;
}

}  // namespace

/// The stiffest and the most viscous contact that a block can have.
template <int D>
typename World<D>::Hardest World<D>::hardest_contact(std::size_t slot, double potential_length) const {
  const auto stiffness_of = [&](const SpringLaw& law) {
    const double spring = std::max(law.normal_stiffness, law.shear_stiffness);
    switch (law.stiffness_kind) {
      case StiffnessKind::per_area:
        return spring * blocks_.largest_face[slot];
      case StiffnessKind::potential:
        return std::max(2 * law.normal_stiffness / potential_length * largest_base<D>(blocks_.radius[slot]),
                        law.shear_stiffness);
      default:
        return spring;
    }
  };
  Hardest hardest;
  for (std::int32_t other = 0; other < material_count(); ++other) {
    const SpringLaw& law = laws_.between(blocks_.material[slot], other);
    const double stiffness = stiffness_of(law);
    const double share = std::max(law.normal_damping, law.shear_damping);
    hardest.stiffness = std::max(hardest.stiffness, stiffness);
    hardest.viscosity = std::max(hardest.viscosity, 2 * share * std::sqrt(stiffness * blocks_.mass[slot]));
  }
  return hardest;
}

/// Square of the largest frequency at which an affine block can vibrate by itself.
template <int D>
double World<D>::wave_of(std::size_t slot) const {
  const Deformation<D>& deformation = blocks_.deformation(slot);
  return deformation.volume * elasticity_of(slot).template largest_stiffness<D>() / deformation.least_moment;
}

/// Gershgorin: no frequency exceeds omega^2 = 2 sum_contacts K (1/m + r^2/I), with r at most the block's
/// radius, and no decay gamma = 2 sum_contacts c (1/m + r^2/I). Dashpots read the velocity of half a step
/// before, so that central differences are stable as long as dt^2 omega^2 + 2 dt gamma < 4. Of an affine
/// block, whose points yield by strain as well, the most yielding takes the place of r^2/I. Blocks will meet
/// others: never fewer than four contacts are counted.
template <int D>
double World<D>::stable_time_step() {
  constexpr int least_contacts = 4;
  contacts_of_.assign(blocks_.slot_count(), 0);
  for (std::size_t c = 0; c < contact_count(); ++c) {
    ++contacts_of_[std::size_t(candidate_of(c).a)];
    ++contacts_of_[std::size_t(candidate_of(c).b)];
  }
  const double length = laws_.knows_potential() ? potential_length() : 0;
  double stable = HUGE_VAL;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (!blocks_.moves_freely(i)) continue;
    const double contacts = std::max(contacts_of_[i], least_contacts);
    const bool is_affine = blocks_.is_affine(i);
    const double turning = is_affine
                               ? blocks_.deformation(i).yield
                               : blocks_.radius[i] * blocks_.radius[i] / blocks_.inertia[i].least_moment();
    const double mobility = 1 / blocks_.mass[i] + turning;
    const Hardest hardest = hardest_contact(i, length);
    double omega_squared = 2 * contacts * hardest.stiffness * mobility;
    double gamma = 2 * contacts * hardest.viscosity * mobility;
    if (is_affine) {
      const double wave = wave_of(i);
      omega_squared += wave;
      gamma += elasticity_of(i).damping_time * wave;
    }
    stable = std::min(stable, 4 / (gamma + std::sqrt(gamma * gamma + 4 * omega_squared)));
  }
  return stable;
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
  Stock stock;
  double weight_times_size = 0;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (blocks_.moves_freely(i)) {
      accelerate(i);
      weight_times_size += blocks_.mass[i] * settings_.gravity.norm() * blocks_.radius[i];
    }
    if (blocks_.is_affine(i)) {
      take_affine_stock(i, blocks_.velocity[i], blocks_.deformation(i).rate, stock);
    } else {
      take_stock(i, blocks_.velocity[i], blocks_.spin[i], stock);
    }
  }
  ledger_.kinetic = stock.kinetic;
  ledger_.gravity = stock.gravity;
  ledger_.block_strain = stock.block_strain;
  power_ = stock.power;
  noise_energy_ = weight_times_size + ledger_.kinetic + ledger_.strain + ledger_.block_strain;
  ledger_.outer_work = ledger_.total() - residual_before_edit_;
}

template class World<2>;
template class World<3>;

}  // namespace halfspace
