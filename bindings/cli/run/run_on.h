#pragma once

#include <cstdint>

#include "model/model.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Continues a stage that runs, and began at `start`, by at most so many steps, fewer while its gradual
/// changes last. @throws LibraryError
void run_on(const SceneStage& stage, Model& model, double start, std::int64_t max_steps);

}  // namespace halfspace::cli
