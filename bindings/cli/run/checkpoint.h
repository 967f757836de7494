#pragma once

#include <string>

#include "model/model.h"

namespace halfspace::cli {

/// The name of a run's checkpoint in its directory.
inline constexpr const char* checkpoint_name = "checkpoint";

/// The hash of everything that a checkpoint and a run that resumes from it have in common: the initial world,
/// prescribed motions, and the columns of the history. Later stages, durations and output may differ.
std::string fingerprint(const Scene& scene, const Model& start);

/// The state of a run with a version line and a checksum.
std::string sealed(const std::string& state);

/// The state in a checkpoint. @throws std::runtime_error if the file cannot be read, is damaged, or is no
/// checkpoint
std::string open_checkpoint(const std::string& file);

}  // namespace halfspace::cli
