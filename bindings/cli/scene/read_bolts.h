#pragma once

#include <vector>

#include "scene/keys.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// The tables `[[bolt]]`.
void read_bolts(std::vector<Keys> tables, Scene& scene);

/// The key `install` of a stage: indices of bolts, which are then not installed at the start.
std::vector<std::size_t> read_installed(Keys& keys, Scene& scene);

}  // namespace halfspace::cli
