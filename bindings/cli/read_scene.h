#pragma once

#include <string>

#include "faults.h"
#include "scene.h"

namespace halfspace::cli {

/// Reads a scene file. Everything wrong with it goes to the faults; the scene is whole only when there are
/// none.
/// @throws std::runtime_error if the file cannot be read
Scene read_scene(const std::string& file, Faults& faults);

/// The same of the text of a file, whose path tells where the files are that it names.
Scene read_scene_text(const std::string& content, const std::string& file, Faults& faults);

}  // namespace halfspace::cli
