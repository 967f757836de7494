#pragma once

#include <optional>
#include <string>

#include "commands/commands.h"

namespace halfspace::cli {

/// The quantity that the search for a limit varies: the tilt, the loads, or the setting `key=low:high`.
struct LimitOptions {
  bool tilts = false;
  std::string axis;                 ///< of the tilt: x, y, z, -x, ..., or empty: z in the plane, x in space
  std::optional<std::string> load;  ///< group or mesh whose loads are scaled; empty: all
  std::optional<double> low, high;  ///< the bracket of a tilt or a load
  double resolution = 0;            ///< 0: a thousandth of the bracket
  double limit = 0;                 ///< m, displacement of a fallen block; 0: by its size
  bool smallest = false;
  bool resumes = false;
};

/// `halfspace limit`: finds the largest, or the smallest, value at which a scene is stable.
int limit(const SceneFile& file, const Target& target, const LimitOptions& options);

}  // namespace halfspace::cli
