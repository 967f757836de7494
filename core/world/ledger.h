#pragma once

namespace halfspace {

/// Where the energy is and where it went.
struct Ledger {
  double kinetic = 0;
  double gravity = 0;
  double strain = 0;        // of contacts
  double block_strain = 0;  // of affine blocks
  double friction_loss = 0;
  double contact_damping_loss = 0;
  double local_damping_loss = 0;
  double mass_damping_loss = 0;
  double block_damping_loss = 0;  // in affine blocks
  double outer_work = 0;

  double losses() const {
    return friction_loss + contact_damping_loss + local_damping_loss + mass_damping_loss + block_damping_loss;
  }
  double total() const { return kinetic + gravity + strain + block_strain + losses(); }
  /// What the numbers themselves made (> 0) or lost (< 0).
  double residual() const { return total() - outer_work; }
};

}  // namespace halfspace
