#pragma once

#include <toml++/toml.h>

#include "scene/faults.h"

namespace halfspace::cli {

/// Notes each value of a scene file that is probably in another unit: a density in t/m3, a strength in MPa,
/// an angle in radians.
void note_unusual_values(const toml::table& scene, Faults& faults);

}  // namespace halfspace::cli
