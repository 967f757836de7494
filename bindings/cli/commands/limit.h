#pragma once

#include <optional>
#include <string>

#include "commands/commands.h"
#include "commands/limit_search.h"

namespace halfspace::cli {

/// The options of the command; the setting `key=low:high` is one of the scene's.
struct LimitArguments {
  bool tilts = false;
  std::string axis;                 ///< of the tilt
  std::optional<std::string> load;  ///< group or mesh whose loads are scaled; empty: all
  LimitOptions search;
};

/// `halfspace limit`: finds the largest, or the smallest, value at which a scene is stable.
int limit(SceneFile file, const Target& target, const LimitArguments& arguments);

}  // namespace halfspace::cli
