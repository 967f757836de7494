#pragma once

#include <string>

#include "model.h"

namespace halfspace::cli {

/// The name of a run's checkpoint in its directory.
inline constexpr const char* checkpoint_name = "checkpoint";

/// The part of a scene that a checkpoint has to share with one that goes on from it: the world at its start,
/// how blocks are driven, and the columns of the history. Stages to come, durations and outputs may be
/// others.
std::string fingerprint(const Model& start);

/// The state of a run with what tells a damaged file and one of another version from a whole one.
std::string sealed(const std::string& state);

/// The state in a checkpoint. @throws std::runtime_error if the file cannot be read, is damaged or is none
std::string open_checkpoint(const std::string& file);

}  // namespace halfspace::cli
