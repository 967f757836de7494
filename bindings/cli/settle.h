#pragma once

#include <cstdint>
#include <string>

#include "model.h"
#include "scene.h"

namespace halfspace::cli {

/// The progress of a stage that settles.
struct Settling {
  std::int64_t steps = 0;
  std::int64_t portions = 0;  ///< of its change, that have begun to settle
  bool is_balanced = false;   ///< with the last of them
  bool is_driven = false;     ///< by a support that never stops, so that it cannot come to rest

  bool is_at_rest(const Model& model) const { return is_balanced && model.is_changed(); }
  bool is_over(const SceneStage& stage, const Model& model) const {
    return is_at_rest(model) || is_driven || steps >= stage.relaxation.max_steps;
  }
};

/// The name of a prescribed block, or of a mesh with a support, that moves and never stops; empty where none
/// does.
std::string endless_motion(const Model& model);

/// The block that is farthest from balance, and its largest contact: the end of a sentence, or empty where no
/// force is unbalanced.
std::string largest_force_block(const Model& model, const hs_balance& balance);

/// Goes on with a stage that is not over, by so few steps that who wants to interrupt it does not wait for
/// long.
/// @throws LibraryError
hs_balance settle_on(const SceneStage& stage, Model& model, Settling& settling);

/// Brings a world to rest in a stage that has begun and settles, once for each portion of its change. False
/// when it is not at rest after the stage's steps, or was interrupted. @throws LibraryError
bool settle(const SceneStage& stage, Model& model, hs_balance& balance);

}  // namespace halfspace::cli
