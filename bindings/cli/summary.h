#pragma once

#include <algorithm>
#include <limits>
#include <string>

#include "model.h"
#include "run.h"

namespace halfspace::cli {

/// How far the blocks that move freely spread horizontally, along x and, in 3D, y: those that are there at
/// the end.
struct RunOut {
  double forwards[2] = {};  ///< farthest vertex at the end beyond the farthest at the start
  double backwards[2] = {};
  double moved_out = 0;  ///< share of the mass whose centroid lies beyond the extent at the start
};

RunOut run_out(const Frame& start, const Frame& end, int dimension);

/// Peaks of what the report tells of the present only, and speeds of the whole run. It is looked at once in a
/// few steps, as looking costs about as much as a step.
struct Peaks {
  static constexpr std::int64_t steps_between = 16;
  void add(const hs_world_report& report) {
    overlap = std::max(overlap, report.peak_overlap);
    if (report.stable_time_step > 0) stable_time_step = std::min(stable_time_step, report.stable_time_step);
    stop = std::max(stop, report.max_penetration_ratio);
  }
  double overlap = 0;  ///< of steps in between, too, but by potentials in space
  double stable_time_step = std::numeric_limits<double>::infinity();  ///< the least
  double stop = 0;
};

/// Nothing of a run whose losses are losses. One below zero by more than rounding is energy that was made,
/// which the residual does not show.
std::string negative_losses_text(const hs_world_report& report, double broken_and_struck);

/// What came out, a line for each figure. The same scene gives the same text.
std::string summary(const Scene& scene, const Model& model, const Peaks& peaks, const Frame& start,
                    const Frame& end, Outcome outcome);

/// The speed of so many steps.
std::string timings(const hs_world_report& report, std::int64_t steps, double seconds);

}  // namespace halfspace::cli
