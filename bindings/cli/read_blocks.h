#pragma once

#include "keys.h"
#include "scene.h"

namespace halfspace::cli {

/// Reads all blocks and generators from the top of a scene, whose materials are known. Are there any?
bool read_blocks(Keys& top, Scene& scene);

}  // namespace halfspace::cli
