#pragma once

#include <string>

#include "library.h"
#include "model.h"
#include "scene.h"
#include "trade/quantity.h"

namespace halfspace::cli {

struct PlanOptions {
  double time = 0;  ///< s to run; 0: the scene's duration
  double tolerance =
      0.01;  ///< how far, as a share of its size, a block may end from where the whole scene puts it
};

struct PlanResult {
  std::string report;
  RunEnd end = RunEnd::whole;  ///< of the scene as it is, or interrupted in any of the runs
};

/// Tells what a scene makes the library compute, what that costs, what limits its step, and what could be
/// left out: the scene is run as it is and without each of its parts. @throws LibraryError
PlanResult plan(const Scene& scene, const PlanOptions& options);

}  // namespace halfspace::cli
