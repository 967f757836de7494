#pragma once

#include "heap.h"

namespace halfspace_benchmark {

/// A Box2D world of the same bins, with lengths and gravity fifty times as large: Box2D's skins and
/// tolerances are made for blocks of about 1 m. It steps by 1/60 s with 8 velocity and 3 position iterations,
/// as its manual has it, nothing sleeps, and continuous collision is off. Returns the seconds that one step
/// takes, the least of `steps` after as many to get going.
double box2d_step_seconds(const Bin& bin, int bins, int steps);

}  // namespace halfspace_benchmark
