#pragma once

#include <algorithm>
#include <tuple>

#include "geometry/tolerances.h"

namespace halfspace {

/// Energies, losses and external work, J; in 2D per unit thickness.
struct Ledger {
  double kinetic = 0;
  double gravity = 0;
  double strain = 0;        // of contacts, bonds and bolts
  double block_strain = 0;  // of deformable blocks
  double friction_loss = 0;
  double fracture_loss = 0;  // of bonds
  double impact_loss = 0;    // of hard contacts
  double contact_damping_loss = 0;
  double local_damping_loss = 0;
  double mass_damping_loss = 0;
  double block_damping_loss = 0;  // in deformable blocks
  double outer_work = 0;
  double water = 0;      // potential energy of blocks in water
  double bolt_loss = 0;  // by yield and rupture

  double losses() const {
    return friction_loss + fracture_loss + impact_loss + contact_damping_loss + local_damping_loss +
           mass_damping_loss + block_damping_loss + bolt_loss;
  }
  double total() const { return kinetic + gravity + water + strain + block_strain + losses(); }
  /// The energy that the numerical method has created (> 0) or lost (< 0).
  double residual() const { return total() - outer_work; }
};

/// Power that prescribed motion, and torques on affine blocks, add, and that damping dissipates, W.
struct Power {
  double outer = 0;
  double contact_damping = 0;
  double local_damping = 0;
  double mass_damping = 0;
  double block_damping = 0;

  void add(const Power& more) {
    outer += more.outer;
    contact_damping += more.contact_damping;
    local_damping += more.local_damping;
    mass_damping += more.mass_damping;
    block_damping += more.block_damping;
  }
};

/// Sums and maxima over the blocks.
struct EnergySample {
  double kinetic = 0;
  double gravity = 0;
  double block_strain = 0;
  double squared_speed = 0;  // maximum
  double squared_swing = 0;  // maximum, of points relative to their centroid
  double applied_power = 0;  // of applied forces, at the velocity in the middle of the motion
  Power power;

  void add(const EnergySample& more) {
    kinetic += more.kinetic;
    gravity += more.gravity;
    block_strain += more.block_strain;
    squared_speed = std::max(squared_speed, more.squared_speed);
    squared_swing = std::max(squared_swing, more.squared_swing);
    applied_power += more.applied_power;
    power.add(more.power);
  }
};

/// Updates the ledger of a world in each motion, and detects instability.
class EnergyLedger {
 public:
  const Ledger& entries() const { return entries_; }

  void set_contact_strain(double strain) { entries_.strain = strain; }
  void add_contact_strain(double strain) { entries_.strain += strain; }
  void set_water(double energy) { entries_.water = energy; }
  void add_bolt_loss(double loss) { entries_.bolt_loss += loss; }
  void add_friction_loss(double loss) { entries_.friction_loss += loss; }
  void add_fracture_loss(double loss) { entries_.fracture_loss += loss; }
  void add_impact_loss(double loss) { entries_.impact_loss += loss; }
  void add_outer_work(double work) { entries_.outer_work += work; }
  void add_contact_damping_loss(double loss) { entries_.contact_damping_loss += loss; }
  void add_outer_power(double power) { power_.outer += power; }

  /// Call before the first external change since the last motion.
  void note_edit() { residual_before_edit_ = entries_.residual(); }

  /// Restarts after an edit, whose change of energy is external work. `noise`: the energy of rounding errors,
  /// and of a motion of the blocks by their own size under their weights and applied loads.
  void begin(const EnergySample& sample, double noise) {
    take(sample);
    noise_energy_ = noise + entries_.kinetic + entries_.strain + entries_.block_strain;
    entries_.outer_work = entries_.total() - residual_before_edit_;
  }

  /// Books a motion. The trapezoidal rule between the powers at its ends is as accurate as the step.
  void book(const EnergySample& sample, double duration) {
    const double half = 0.5 * duration;
    const Power &before = power_, &after = sample.power;
    entries_.contact_damping_loss += half * (before.contact_damping + after.contact_damping);
    entries_.local_damping_loss += half * (before.local_damping + after.local_damping);
    entries_.mass_damping_loss += half * (before.mass_damping + after.mass_damping);
    entries_.block_damping_loss += half * (before.block_damping + after.block_damping);
    entries_.outer_work += duration * sample.applied_power + half * (before.outer + after.outer);
    take(sample);
  }

  /// True when the numerical method has created nearly all of the present energy. (Just below the stable
  /// step, the residual of a spring oscillates by the fraction q^2 of its energy, q being the time step over
  /// the stable one.) Where nothing moves and nothing is strained, the residual is rounding.
  bool is_unstable() const {
    const double made = entries_.residual(),
                 stored = entries_.kinetic + entries_.strain + entries_.block_strain;
    const double present = stored + entries_.losses();
    return stored != 0 && !(made <= created_ratio * present || made <= noise_energy_);
  }

  /// State that is written before a motion.
  auto state() { return std::tie(entries_, noise_energy_, residual_before_edit_, power_); }

  /// All numbers of the ledger: those of shares of a world add up to those of the whole.
  struct Sums {
    Ledger entries;
    double noise_energy;
    double residual_before_edit;
    Power power;
  };
  Sums sums() const { return {entries_, noise_energy_, residual_before_edit_, power_}; }
  void set_sums(const Sums& sums) {
    state() = std::tie(sums.entries, sums.noise_energy, sums.residual_before_edit, sums.power);
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(entries_, noise_energy_, residual_before_edit_, power_);
  }

 private:
  void take(const EnergySample& sample) {
    entries_.kinetic = sample.kinetic;
    entries_.gravity = sample.gravity;
    entries_.block_strain = sample.block_strain;
    power_ = sample.power;
  }

  Ledger entries_;
  double noise_energy_ = 0;  // J; a residual below it does not count as instability
  double residual_before_edit_ = 0;
  Power power_;  // at the last forces
};

}  // namespace halfspace
