#pragma once

#include "faults.h"
#include "model.h"
#include "scene.h"

namespace halfspace::cli {

/// Tells what of a scene, ready to run, is legal but seldom meant: blocks that overlap, a boundary the wrong
/// way round, a time step above the stable one, springs too soft for weights or speeds.
void note_start(const Context& context, const Scene& scene, const Model& model, Faults& faults);

}  // namespace halfspace::cli
