#pragma once

#include "model/layout.h"

namespace halfspace::cli {

/// True if the library lets a block follow an action: loads act on free blocks, motions on prescribed blocks
/// and along held axes.
bool can_follow(const LayoutBlock& block, const Action& action, int dimension);

/// The blocks that can follow an action, in words.
const char* followers(const Action& action);

}  // namespace halfspace::cli
