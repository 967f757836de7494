#pragma once

#include <vector>

#include "scene/keys.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Reads the [[bond]] tables of a scene, after its materials.
void read_bonds(std::vector<Keys> tables, Scene& scene);

/// Reads the [[stage]] tables of a scene.
void read_stages(std::vector<Keys> tables, Scene& scene);

}  // namespace halfspace::cli
