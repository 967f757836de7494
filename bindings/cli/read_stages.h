#pragma once

#include <vector>

#include "keys.h"
#include "scene.h"

namespace halfspace::cli {

/// Reads the [[bond]] tables of a scene, whose materials are known.
void read_bonds(std::vector<Keys> tables, Scene& scene);

/// Reads the [[stage]] tables of a scene.
void read_stages(std::vector<Keys> tables, Scene& scene);

}  // namespace halfspace::cli
