#include "model/followers.h"

namespace halfspace::cli {
namespace {

bool is_load(const Action& action) {
  return action.kind == HS_ACTION_FORCE || action.kind == HS_ACTION_TORQUE;
}

}  // namespace

bool can_follow(const LayoutBlock& block, const Action& action, int dimension) {
  if (is_load(action)) return block.kind == HS_BLOCK_RIGID || block.kind == HS_BLOCK_AFFINE;
  if (block.kind == HS_BLOCK_PRESCRIBED) return true;
  const bool is_angular =
      action.kind == HS_ACTION_ANGULAR_VELOCITY || action.kind == HS_ACTION_ANGULAR_ACCELERATION;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    if (action.scale[axis] != 0 && (block.motion.held_axes >> axis & 1) == 0) return false;
  return block.kind == HS_BLOCK_RIGID && !is_angular;
}

const char* followers(const Action& action) {
  return is_load(action) ? "a rigid or affine block; a mesh takes loads by [[mesh.load]]"
                         : "a prescribed block, or a rigid one with these axes in its key hold";
}

}  // namespace halfspace::cli
