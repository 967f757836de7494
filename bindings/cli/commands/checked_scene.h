#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "model/layout.h"
#include "model/library.h"
#include "scene/faults.h"
#include "scene/scene.h"

namespace halfspace::cli {

enum ExitCode { exit_ok = 0, exit_failed = 1, exit_usage = 2, exit_unstable = 3 };

/// A scene as the command line names it.
struct SceneFile {
  std::string path;
  std::vector<std::string> settings = {};   ///< `key=value`, which replace values of the file
  std::optional<std::string> content = {};  ///< instead of the bytes of the file
};

/// A scene, its blocks and the context that owns them; complete only without faults.
struct CheckedScene {
  Context context;
  Scene scene;
  Layout layout;
  Faults faults;
};

/// Reads a scene. With 0 threads the scene gives their number.
CheckedScene read(const SceneFile& file, int threads);
/// Makes the blocks of a scene that was read.
void lay_out(CheckedScene& checked);
/// Both.
CheckedScene load(const SceneFile& file, int threads);

/// Prints the faults of a scene. @return the exit code
int refuse(const SceneFile& file, const Faults& faults);

/// All that a scene is made of: its own file, its settings, and the files of its blocks and meshes.
std::string bytes_of(const SceneFile& file, const Scene& scene);

/// Adds a fault to a scene in which nothing moves freely; `by` names what requires a block that does.
void require_free_block(CheckedScene& checked, const std::string& by);

void print(std::FILE* stream, const std::string& text);

}  // namespace halfspace::cli
