#pragma once

#include <cstdint>

#include "world/relaxation/balance.h"
#include "world/world.h"

namespace halfspace {

/// Parameters of a dynamic relaxation.
struct Relaxation {
  bool by_largest = false;  // criterion: largest ratio; false: mean ratio
  double ratio = 1e-5;
  std::int64_t max_steps = 1000000;
  double local_damping = 0.1;
  bool is_adaptive = true;  // mass damping critical for the slowest remaining motion
  bool holds_bonds = true;
  double max_displacement = 0;  // failure beyond it, over a block's size; 0: no limit
};

/// The result of a relaxation.
struct Relaxed {
  StepResult result = StepResult::ok;
  bool is_at_rest = false;
  bool has_failed = false;  // some block has moved beyond max_displacement
  std::int64_t steps = 0;
  Balance balance;
};

/// Dynamic relaxation: steps under damping until forces balance (Cundall 1987). At rest, sets all free
/// velocities to 0. Damping and bonds are as before. If memory runs out before anything has moved, a world
/// that was ready for its next step still is.
template <int D>
Relaxed relax(World<D>& world, const Relaxation& relaxation);

/// The balance of a world as its next step begins. If there is no stable time step, no block moves freely,
/// and nothing is unbalanced.
template <int D>
Balance balance_of(World<D>& world);

extern template Relaxed relax(World<2>&, const Relaxation&);
extern template Relaxed relax(World<3>&, const Relaxation&);
extern template Balance balance_of(World<2>&);
extern template Balance balance_of(World<3>&);

}  // namespace halfspace
