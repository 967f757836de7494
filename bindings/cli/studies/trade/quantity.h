#pragma once

#include <optional>
#include <string>

#include "model/model.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// The ends of a run for a quantity.
enum class RunEnd {
  whole,
  interrupted,
  unstable,
  too_fast,
  not_at_rest,    ///< a stage has not settled within its max_steps
  inverted,       ///< a cell of a mesh would turn inside out
  too_few_steps,  ///< fewer than ten
  no_angle        ///< stable without friction, or not stable at 89 degrees
};

/// The result of a run, and its cost.
struct Outcomes {
  RunEnd end = RunEnd::whole;
  double value = 0;
  double start = 0;        ///< the value before the first step
  double cpu_seconds = 0;  ///< of all threads, for stepping only
  double simulated = 0;    ///< s; 1 for a scene with stages, whose cost is that of all stages
  double time = 0;         ///< s, of the measurement
};

/// Steps a model to the time of its reference, or through its stages, and measures the quantity. A friction
/// angle requires many runs, see measure(). @throws LibraryError
Outcomes run_for_quantity(const Scene& scene, Model& model);

/// All blocks at a time within half a step of that of the model: extrapolated by their velocities.
Frame frame_at(const Model& model, double time);

/// The quantity in words: "position of block along x at 2 s".
std::string describe_quantity(const Scene& scene);
/// The unit of a run's cost.
const char* unit_of_cost(const Scene& scene);
/// The unit of a quantity.
const char* unit_of(Quantity quantity);

}  // namespace halfspace::cli
