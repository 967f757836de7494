#pragma once

#include <vector>

#include "scene/keys.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Reads the tables of `tracked`.
void read_tracked_points(std::vector<Keys> tables, Scene& scene);

/// Reads `joints`.
void read_tracked_joints(std::vector<Keys> tables, Scene& scene);

}  // namespace halfspace::cli
