#pragma once

#include <string>

#include "scene/faults.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Reads a scene file. Its errors are added to the faults; the scene is complete only without faults.
/// @throws std::runtime_error if the file cannot be read
Scene read_scene(const std::string& file, Faults& faults);

/// The same for the text of a file. Relative file names in it refer to the folder of `file`.
Scene read_scene_text(const std::string& content, const std::string& file, Faults& faults);

}  // namespace halfspace::cli
