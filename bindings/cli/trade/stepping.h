#pragma once

#include <cstdint>
#include <functional>

#include "model.h"
#include "scene.h"
#include "trade/quantity.h"

namespace halfspace::cli {

/// The things that are asked of a run on its way.
struct OnTheWay {
  std::int64_t steps_at_once = 1;         ///< between two looks
  std::function<void()> look = {};        ///< after these, and when it has settled
  std::function<void()> count_anew = {};  ///< displacements, as a stage says
};

/// Steps a model through the stages of its scene, or, without any, to the time of its reference. `end_time`
/// becomes the time that the last of them is meant to end at. @throws LibraryError
RunEnd step_through(const Scene& scene, Model& model, const OnTheWay& way, double& end_time);

}  // namespace halfspace::cli
