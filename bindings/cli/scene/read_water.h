#pragma once

#include <optional>

#include "scene/keys.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// The table `water` of a scene or of a stage; empty if there is none. Keys that a stage leaves out keep the
/// value that they had before.
std::optional<Water> read_water(Keys& keys, const std::optional<Water>& before);

}  // namespace halfspace::cli
