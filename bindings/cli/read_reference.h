#pragma once

#include "keys.h"
#include "scene.h"

namespace halfspace::cli {

/// Reads `[reference]`, when the duration of the scene is known.
void read_reference(Keys keys, Scene& scene);

}  // namespace halfspace::cli
