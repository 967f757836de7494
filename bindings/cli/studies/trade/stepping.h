#pragma once

#include <cstdint>
#include <functional>

#include "model/model.h"
#include "scene/scene.h"
#include "studies/trade/quantity.h"

namespace halfspace::cli {

/// Callbacks on the way of a run.
struct StepCallbacks {
  std::int64_t steps_at_once = 1;                 ///< between two calls of observe
  std::function<void()> observe = {};             ///< after these steps, and after settling
  std::function<void()> reset_displacement = {};  ///< at the start of a stage that resets them
};

/// Steps a model through the stages of its scene or, without any, to the time of its reference. `end_time` is
/// set to the nominal end of the last stage. @throws LibraryError
RunEnd step_through(const Scene& scene, Model& model, const StepCallbacks& callbacks, double& end_time);

}  // namespace halfspace::cli
