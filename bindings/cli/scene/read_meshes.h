#pragma once

#include <vector>

#include "scene/keys.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Reads the [[mesh]] tables of a scene, after its materials.
void read_meshes(std::vector<Keys> tables, Scene& scene);

}  // namespace halfspace::cli
