#pragma once

#include <algorithm>
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

/// The largest values of a run. They are looked at once in a few steps: looking costs about as much as a
/// step, and a contact lasts longer than that.
struct Peaks {
  static constexpr std::int64_t steps_between = 16;
  void add(const hs_world_report& report) {
    overlap = std::max(overlap, report.largest_overlap);
    speed = std::max(speed, report.largest_speed);
    stop = std::max(stop, report.deepest_stop);
  }
  double overlap = 0;
  double speed = 0;
  double stop = 0;
};

/// What came out, a line for each figure. The same scene gives the same text.
std::string summary(const Scene& scene, const Model& model, const Peaks& peaks, const Frame& start,
                    const Frame& end, Outcome outcome);

/// How fast it was.
std::string timings(const hs_world_report& report, double seconds);

}  // namespace halfspace::cli
