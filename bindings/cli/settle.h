#pragma once

#include "model.h"
#include "scene.h"

namespace halfspace::cli {

/// Brings a world to rest in a stage that has begun and settles, once for each portion of its change. False
/// when it is not at rest after the stage's steps, or was interrupted. @throws LibraryError
bool settle(const SceneStage& stage, Model& model, hs_balance& balance);

}  // namespace halfspace::cli
