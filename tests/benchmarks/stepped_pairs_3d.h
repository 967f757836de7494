#pragma once

// Pairs of polyhedra on their way, judged step by step as a world does: what their memory saves.

#include "benchmarks/peers_3d.h"

namespace halfspace_benchmark {

/// In ns per pair and step, but for the contact: per contact and step.
struct StepTimes {
  double without_memory = 0;
  double with_memory = 0;
  double contact = 0;    ///< type, plane and region
  double touching = 0;   ///< share of pairs and steps
  long differences = 0;  ///< verdicts that memory has changed
};

/// Each b moves along a line of its own by `motion`, and turns about an axis of its own by `turn` (rad), in
/// each step. Every block is turned where it is before the clock starts, as those of a world are.
StepTimes time_steps(const PairSet3& set, int steps, double motion, double turn, Random& random);

}  // namespace halfspace_benchmark
