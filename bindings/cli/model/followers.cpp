#include "model/followers.h"

namespace halfspace::cli {
namespace {

bool is_angular(const Action& action) {
  return action.kind == HS_ACTION_ANGULAR_VELOCITY || action.kind == HS_ACTION_ANGULAR_ACCELERATION;
}

}  // namespace

bool can_follow(const LayoutBlock& block, const Action& action, int dimension) {
  if (is_load(action.kind)) return block.kind == HS_BLOCK_RIGID || block.kind == HS_BLOCK_AFFINE;
  if (block.kind == HS_BLOCK_PRESCRIBED) return true;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    if (action.scale[axis] != 0 && (block.motion.held_axes >> axis & 1) == 0) return false;
  return block.kind == HS_BLOCK_RIGID && !is_angular(action);
}

const char* followers(const Action& action) {
  return is_load(action.kind) ? "a rigid or affine block; a mesh takes loads by [[mesh.load]]"
                              : "a prescribed block, or a rigid one with these axes in its key hold";
}

std::optional<std::string> GivenAxes::add(std::optional<std::size_t> block, std::size_t index,
                                          const Action& action) {
  if (is_load(action.kind)) return std::nullopt;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool is_in_plane = is_angular(action) ? axis == 2 : axis < 2;
    if (action.scale[axis] == 0 || (dimension_ == 2 && !is_in_plane)) continue;
    const std::size_t which = axis + (is_angular(action) ? 3 : 0);
    const auto taken = taken_.try_emplace({action.stage, block ? *block + 1 : 0, which}, index).first;
    if (taken->second == index) continue;
    return std::string(is_angular(action) ? "a rotation about " : "a motion along ") + "xyz"[axis] +
           " by action[" + std::to_string(taken->second) +
           "] of the same stage; allowed: one motion per axis, as by rows [time, value] along a direction";
  }
  return std::nullopt;
}

}  // namespace halfspace::cli
