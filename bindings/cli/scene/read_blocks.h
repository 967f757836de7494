#pragma once

#include "scene/keys.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Reads all blocks and generators of a scene, after its materials. @return true if there are any
bool read_blocks(Keys& top, Scene& scene);

}  // namespace halfspace::cli
