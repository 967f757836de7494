#pragma once

#include "model/model.h"
#include "scene/faults.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Adds notes about legal but unusual input of a scene that is ready to run. The kinds are in notes/kinds.h.
void note_start(const Context& context, const Scene& scene, const Model& model, Faults& faults);

/// A run without a time step ends at its first step. @throws SceneFault
void require_time_step(const Context& context, const Scene& scene, const Model& model);

}  // namespace halfspace::cli
