#pragma once

#include <string>

#include "commands/commands.h"

namespace halfspace::cli {

struct SweepOptions {
  bool finds_safety = false;  ///< the factor of safety, instead of a run
  int runs_at_once = 0;       ///< 0: as many as there are cores
  std::string plotted;        ///< column of table.svg; empty: the first result that was asked for
  bool resumes = false;       ///< from the runs in the directory
};

/// `halfspace sweep`: runs a scene for each combination of the values of its settings.
int sweep(const SceneFile& file, const Target& target, const SweepOptions& options);

}  // namespace halfspace::cli
