#pragma once

#include <cstdint>
#include <string>

#include "common/box.h"
#include "model/model.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// The progress of a stage that settles.
struct Settling {
  std::int64_t steps = 0;
  std::int64_t portions = 0;  ///< number of portions that have begun
  bool is_balanced = false;   ///< after the last of them
  bool is_driven = false;     ///< a support never stops, so that there is no rest
  std::string fallen = {};    ///< a block that has fallen out of the scene
  Box scene = {};             ///< around all blocks at the first steps

  bool is_at_rest(const Model& model) const { return is_balanced && model.is_changed(); }
  bool is_over(const SceneStage& stage, const Model& model) const {
    return is_at_rest(model) || is_driven || !fallen.empty() || steps >= stage.relaxation.max_steps;
  }
};

/// The name of a prescribed block, or of a mesh with a support, that moves and never stops; empty if there is
/// none.
std::string endless_motion(const Model& model);

/// The block with the largest unbalanced force, and its largest contact, as the end of a sentence; empty in
/// balance.
std::string largest_force_block(const Model& model, const hs_balance& balance);

/// Continues a stage that is not over, by few steps, so that interrupts are prompt. @throws LibraryError
hs_balance settle_on(const SceneStage& stage, Model& model, Settling& settling,
                     std::int64_t steps_of_piece = 20000);

/// Settles a stage that has begun, portion by portion. False if it is not at rest after its max_steps, or was
/// interrupted. @throws LibraryError
bool settle(const SceneStage& stage, Model& model, hs_balance& balance);

}  // namespace halfspace::cli
