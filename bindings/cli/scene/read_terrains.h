#pragma once

#include <vector>

#include "scene/keys.h"
#include "scene/scene.h"

namespace halfspace::cli {

void read_terrains(std::vector<Keys> tables, Scene& scene);

}  // namespace halfspace::cli
