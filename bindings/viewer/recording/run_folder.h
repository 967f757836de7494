#pragma once

#include <functional>
#include <optional>
#include <string>

#include "recording/recording.h"

namespace halfspace::viewer {

/// The content of a file in the output directory of a run, by its name there; nothing if there is none.
using RunFiles = std::function<std::optional<std::string>(const std::string& name)>;

/// The recording of a run, from the files in its output directory: frames, contacts, bolts, water, cracks and
/// history. @throws std::runtime_error that names a file if it cannot be read, or is none of a run
Recording read_run(const std::string& folder);
/// The same from files anywhere; `folder` is the directory in messages and in the title.
Recording read_run(const RunFiles& files, const std::string& folder);

}  // namespace halfspace::viewer
