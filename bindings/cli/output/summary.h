#pragma once

#include <algorithm>
#include <limits>
#include <string>

#include "model/model.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// How a run ended: by its duration, at rest, by a signal, or at a step that was unstable or refused.
enum class Outcome { complete, at_rest, interrupted, unstable, too_fast };

/// The horizontal spread of the free blocks along x and, in 3D, y; without excavated blocks.
struct RunOut {
  double forwards[2] = {};  ///< farthest vertex at the end beyond the farthest at the start
  double backwards[2] = {};
  double moved_out = 0;  ///< fraction of the mass with centroids beyond the extent at the start

  double farthest() const { return std::max({forwards[0], backwards[0], forwards[1], backwards[1]}); }
};

RunOut run_out(const Frame& start, const Frame& end, int dimension);

/// Peak values of a run. They are sampled every few steps, as a sample costs about as much as a step.
struct Peaks {
  static constexpr std::int64_t steps_between = 16;
  void add(const hs_world_report& report) {
    overlap = std::max(overlap, report.peak_overlap);
    if (report.stable_time_step > 0) stable_time_step = std::min(stable_time_step, report.stable_time_step);
    penetration_ratio = std::max(penetration_ratio, report.max_penetration_ratio);
  }
  double overlap = 0;  ///< m, also between samples, except for potentials in 3D
  double stable_time_step = std::numeric_limits<double>::infinity();  ///< s, min
  double penetration_ratio = 0;  ///< max depth that springs allow, fraction of the thinner thickness
};

/// The first lines of a report: the title of a scene, and its settings.
std::string scene_lines(const Scene& scene);

/// Lists losses below zero by more than rounding: energy that the method has created, and that the residual
/// does not show. Empty without any, and where the residual is as large a loss.
std::string negative_losses_text(const hs_world_report& report, double fracture_loss);

/// A line with a note on a residual above 1 % of the released energy; empty below.
std::string residual_note(const hs_world_report& report, double fracture_loss);

/// The results of a run as numbers.
struct RunFigures {
  double run_out = 0;           ///< m, the farthest
  double max_displacement = 0;  ///< m, of the centroid of a free block
  double largest_overlap = 0;   ///< m, in the whole run
  double energy_residual = 0;   ///< J
};

RunFigures figures_of(const Model& model, const Peaks& peaks, const Frame& start, const Frame& end);

/// The results of a run, a line for each quantity. The same scene gives the same text.
std::string summary(const Scene& scene, const Model& model, const Peaks& peaks, const Frame& start,
                    const Frame& end, Outcome outcome);

/// The speed of so many steps.
std::string timings(const hs_world_report& report, std::int64_t steps, double seconds);

}  // namespace halfspace::cli
