#pragma once

#include <string>
#include <vector>

#include "scene/faults.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Reads a scene file, with settings `key=value` that replace values of it. Its errors are added to the
/// faults; the scene is complete only without faults.
/// @throws std::runtime_error if the file cannot be read
Scene read_scene(const std::string& file, Faults& faults, const std::vector<std::string>& settings = {});

/// The same for the text of a file. Relative file names in it refer to the folder of `file`.
Scene read_scene_text(const std::string& content, const std::string& file, Faults& faults,
                      const std::vector<std::string>& settings = {});

}  // namespace halfspace::cli
