#pragma once

#include "scene/keys.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Reads `[reference]`, after the duration of the scene.
void read_reference(Keys keys, Scene& scene);

}  // namespace halfspace::cli
