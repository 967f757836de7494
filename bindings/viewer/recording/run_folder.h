#pragma once

#include <string>

#include "recording/recording.h"

namespace halfspace::viewer {

/// The recording of a run, from the files in its output directory: frames, contacts, bolts, water, cracks and
/// history. @throws std::runtime_error that names a file if it cannot be read
Recording read_run(const std::string& folder);

}  // namespace halfspace::viewer
