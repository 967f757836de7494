#pragma once

#include <optional>
#include <string>

#include "scene/keys.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// The table `water` of a scene or of a stage; empty if there is none. Keys that a stage leaves out keep the
/// value that they had before. `folder`: of the file of a height map.
std::optional<Water> read_water(Keys& keys, const std::optional<Water>& before, const std::string& folder);

}  // namespace halfspace::cli
