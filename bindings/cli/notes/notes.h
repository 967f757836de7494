#pragma once

#include "faults.h"
#include "model.h"
#include "scene.h"

namespace halfspace::cli {

/// Notes all in a scene, ready to run, that is legal but seldom meant. The kinds are in notes/kinds.h.
void note_start(const Context& context, const Scene& scene, const Model& model, Faults& faults);

}  // namespace halfspace::cli
