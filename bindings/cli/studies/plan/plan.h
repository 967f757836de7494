#pragma once

#include <string>

#include "model/library.h"
#include "model/model.h"
#include "scene/scene.h"
#include "studies/trade/quantity.h"

namespace halfspace::cli {

struct PlanOptions {
  double time = 0;          ///< s to run; 0: the scene's duration
  double tolerance = 0.01;  ///< max displacement error of a block without a part, over its size
};

struct PlanResult {
  std::string report;
  RunEnd end = RunEnd::whole;  ///< of the scene as it is, or interrupted in any of the runs
};

/// Reports the active parts of a scene, their cost, the limit of its time step, and the parts that could be
/// left out. Runs the scene as it is and without each part. @throws LibraryError
PlanResult plan(const Scene& scene, const PlanOptions& options);

}  // namespace halfspace::cli
