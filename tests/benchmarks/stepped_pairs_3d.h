#pragma once

// Pairs of polyhedra on their way, judged step by step as a world does: what their memory saves.

#include "benchmarks/peers_3d.h"

namespace halfspace_benchmark {

/// In ns per pair and step.
struct StepTimes {
  double judged_without_memory = 0;
  double judged = 0;
  double found_without_memory = 0;  ///< with type, plane and region of the contact, where there is one
  double found = 0;
  double touching = 0;   ///< share of pairs and steps
  long differences = 0;  ///< verdicts that memory has changed
};

/// Each b moves along a line of its own by `motion`, and turns about an axis of its own by `turn` (rad), in
/// each step. Every block is turned where it is before the clock starts, as those of a world are.
StepTimes time_steps(const PairSet3& set, int steps, double motion, double turn, Random& random);

}  // namespace halfspace_benchmark
