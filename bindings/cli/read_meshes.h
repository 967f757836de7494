#pragma once

#include <vector>

#include "keys.h"
#include "scene.h"

namespace halfspace::cli {

/// The [[mesh]] tables, once the materials are known.
void read_meshes(std::vector<Keys> tables, Scene& scene);

}  // namespace halfspace::cli
