#pragma once

#include <cstdint>
#include <string>

#include "commands/commands.h"

namespace halfspace::cli {

/// `halfspace split`: cuts a scene, or a snapshot *.hsw, into shares.
int split(const SceneFile& file, std::int64_t count, const Target& target);

/// `halfspace join`: joins the shares in a directory to one snapshot.
int join(const std::string& directory, const std::string& file);

}  // namespace halfspace::cli
