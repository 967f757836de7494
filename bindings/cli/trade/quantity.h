#pragma once

#include <optional>
#include <string>

#include "model.h"
#include "scene.h"

namespace halfspace::cli {

/// The ends that a run for a quantity may have.
enum class RunEnd {
  whole,
  interrupted,
  unstable,
  too_fast,
  not_at_rest,    ///< a stage has not settled in its steps
  inverted,       ///< a cell of a mesh would turn inside out
  too_few_steps,  ///< for the step to be a small part of the time
  no_angle        ///< between 0 and 89 degrees decides whether the scene stands
};

/// The result of a run, and its cost.
struct Outcomes {
  RunEnd end = RunEnd::whole;
  double value = 0;
  double start = 0;        ///< the value before the first step
  double cpu_seconds = 0;  ///< of all threads, stepping alone
  double simulated = 0;    ///< s; 1 of a scene with stages, whose cost is that of all it does
  double time = 0;         ///< s, when the value was taken
};

/// Steps a model to the time of its reference, or through its stages, and takes the quantity. A friction
/// angle needs many runs, see measure(). @throws LibraryError
Outcomes run_for_quantity(const Scene& scene, Model& model);

/// All blocks at a time that the model has reached to half a step: they are carried on from there by their
/// velocities, as a whole number of steps seldom makes up the time.
Frame frame_at(const Model& model, double time);

/// The quantity in words: "position of block along x at 2 s".
std::string describe_quantity(const Scene& scene);
/// The unit of a run's cost.
const char* unit_of_cost(const Scene& scene);
/// Its unit.
const char* unit_of(Quantity quantity);

}  // namespace halfspace::cli
