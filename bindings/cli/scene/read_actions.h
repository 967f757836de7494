#pragma once

#include <vector>

#include "scene/keys.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// The table of a time and factors that a mesh's support or load follows, and the stage that it begins with.
TimeTable read_factors(Keys& keys);
/// The key `stage`: the index of the stage with that name; the first one by default.
std::size_t read_stage_name(Keys& keys, const Scene& scene);

/// The letters of axes: "x", "xy", ... as a sum of HS_AXIS_ values. `with_rotation`: "r" is allowed.
int read_axes(Keys& keys, std::string_view key, const std::string& fallback, bool with_rotation);

/// Precondition: the stages are read.
void read_actions(std::vector<Keys> tables, Scene& scene);

}  // namespace halfspace::cli
