#pragma once

#include <string>

#include "model.h"
#include "run.h"

namespace halfspace::cli {

/// How far the rigid blocks spread horizontally, along x and, in 3D, y.
struct RunOut {
  double forwards[2] = {};  ///< farthest vertex at the end beyond the farthest at the start
  double backwards[2] = {};
  double moved_out = 0;  ///< share of the mass whose centroid lies beyond the extent at the start
};

RunOut run_out(const Frame& start, const Frame& end, int dimension);

/// What came out, a line for each figure. The same scene gives the same text.
std::string summary(const Scene& scene, const Model& model, const Frame& start, const Frame& end,
                    Outcome outcome);

/// How fast it was.
std::string timings(const hs_world_report& report, double seconds);

}  // namespace halfspace::cli
