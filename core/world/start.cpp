#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "force/spring/point_springs.h"
#include "world/world.h"

namespace halfspace {
namespace {

/// The largest area, in the plane the largest width, that blocks of this radius can share.
template <int D>
double largest_base(double radius) {
  return D == 2 ? 2 * radius : std::numbers::pi * radius * radius;
}

}  // namespace

/// The stiffest that a contact of a block can be by a law.
template <int D>
double World<D>::largest_stiffness(const SpringLaw& law, std::size_t slot, double potential_length) const {
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
}

/// The stiffest and the most viscous contact that a block can have: with one far heavier.
template <int D>
typename World<D>::Hardness World<D>::hardest_contact(std::size_t slot, double potential_length) const {
  Hardness hardest;
  for (std::int32_t other = 0; other < material_count(); ++other) {
    const SpringLaw& law = laws_.between(blocks_.material[slot], other);
    const double stiffness = largest_stiffness(law, slot, potential_length);
    hardest.stiffness = std::max(hardest.stiffness, stiffness);
    hardest.viscosity = std::max(hardest.viscosity, law.viscosity(stiffness, blocks_.mass[slot]));
  }
  return hardest;
}

/// Of a contact that is there: no stiffer than the smaller of its blocks allows, and braked by dashpots for
/// the mass that both move together.
template <int D>
typename World<D>::Hardness World<D>::hardness_of(std::size_t c, double potential_length) const {
  const Candidate<D>& pair = candidate_of(c);
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const SpringLaw& law = law_of(pair);
  Hardness hardness;
  hardness.contacts = 1;
  hardness.stiffness =
      std::min(largest_stiffness(law, a, potential_length), largest_stiffness(law, b, potential_length));
  hardness.viscosity = law.is_damped() ? law.viscosity(hardness.stiffness, reduced_mass(a, b)) : 0;
  if (law.stiffness_kind == StiffnessKind::per_contact)
    hardness.turning_stiffness =
        law.normal_stiffness * turning_stiffness_of_shares(contact(c), settings_.detect.parallel_angle);
  return hardness;
}

/// Square of the largest frequency at which an affine block can vibrate by itself.
template <int D>
double World<D>::wave_of(std::size_t slot) const {
  const Deformation<D>& deformation = blocks_.deformation(slot);
  return deformation.volume * elasticity_of(slot).template largest_stiffness<D>() / deformation.least_moment;
}

/// Gershgorin: no frequency exceeds omega^2 = sum_contacts n (K (1/m + y) + E/I), with y = r^2/I of the point
/// that yields most to a force, E what the shares of a region's stiffness add to it as they change with the
/// tilt, and n = 2, or 1 where the other block stands still; and no decay gamma = sum_contacts n c (1/m + y).
/// Dashpots read the velocity of half a step before, so that central differences are stable as long as
/// dt^2 omega^2 + 2 dt gamma < 4. Blocks will meet others: never fewer than four contacts are counted.
template <int D>
double World<D>::stable_time_step() {
  constexpr int least_contacts = 4;
  const double length = laws_.knows_potential() ? potential_length() : 0;
  hardness_.assign(blocks_.slot_count(), {});
  for (std::size_t c = 0; c < contact_count(); ++c) {
    const std::size_t a = std::size_t(candidate_of(c).a), b = std::size_t(candidate_of(c).b);
    const Hardness hardness = hardness_of(c, length);
    const int times = blocks_.moves_freely(a) && blocks_.moves_freely(b) ? 2 : 1;
    hardness_[a].add(hardness, times);
    hardness_[b].add(hardness, times);
  }
  double stable = HUGE_VAL;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (!blocks_.moves_freely(i)) continue;
    Hardness& all = hardness_[i];
    all.add(hardest_contact(i, length), 2 * std::max(least_contacts - all.contacts, 0));
    const bool is_affine = blocks_.is_affine(i);
    const double moment = is_affine ? blocks_.deformation(i).least_moment : blocks_.inertia[i].least_moment();
    const double mobility = 1 / blocks_.mass[i] + blocks_.yield(i);
    double omega_squared = all.stiffness * mobility + all.turning_stiffness / moment;
    double gamma = all.viscosity * mobility;
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
    // One that is divided where blocks are fast need not know of speeds.
    if (settings_.fast_blocks == FastBlocks::refuse) chosen = std::min(chosen, calm_time_step());
  }
  if (!std::isfinite(chosen) || chosen <= 0) return false;
  if (chosen == time_step_) return true;
  epoch_time_ = now;
  epoch_step_ = steps_;
  passed_ = 0;
  time_step_ = chosen;
  return true;
}

/// Accelerations and energies of the present state; what an edit has done to the energy is outer work. Energy
/// that comes of rounding is noise: of a position that is off by rounding, in a step.
template <int D>
void World<D>::start_ledger() {
  Stock stock;
  double weight_times_size = 0, rounding_energy = 0;
  for (std::size_t i = 0; i < blocks_.slot_count(); ++i) {
    if (blocks_.moves_freely(i)) {
      accelerate(i);
      weight_times_size += blocks_.mass[i] * settings_.gravity.norm() * blocks_.radius[i];
      const double reach = blocks_.position[i].norm() + blocks_.radius[i];
      const double speed = std::numeric_limits<double>::epsilon() * reach / time_step_;
      rounding_energy += blocks_.mass[i] * speed * speed;
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
  note_speeds(stock);
  power_ = stock.power;
  noise_energy_ =
      weight_times_size + rounding_energy + ledger_.kinetic + ledger_.strain + ledger_.block_strain;
  ledger_.outer_work = ledger_.total() - residual_before_edit_;
}

template class World<2>;
template class World<3>;

}  // namespace halfspace
