#include "output/summary.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"
#include "common/vector.h"

namespace halfspace::cli {
namespace {

/// Horizontal bounds of all blocks that move freely.
struct Extent {
  double low[2] = {INFINITY, INFINITY};
  double high[2] = {-INFINITY, -INFINITY};

  bool holds(const double position[3], std::size_t axes) const {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      if (position[axis] < low[axis] || position[axis] > high[axis]) return false;
    }
    return true;
  }
};

/// The extent of the blocks that are still there at the end.
Extent extent_of(const Frame& frame, const Frame& end) {
  Extent extent;
  for (std::size_t i = 0; i < frame.blocks.size(); ++i) {
    if (!moves_freely(end.blocks[i].state.kind)) continue;
    for (const Point& p : frame.blocks[i].vertices) {
      for (std::size_t axis : {0, 1}) {
        extent.low[axis] = std::min(extent.low[axis], p[axis]);
        extent.high[axis] = std::max(extent.high[axis], p[axis]);
      }
    }
  }
  return extent;
}

std::string blocks_text(const Layout& layout, const Frame& end) {
  int counts[5] = {};
  for (const LayoutBlock& block : layout.blocks) ++counts[block.kind];
  std::string text = std::to_string(layout.blocks.size()) + " (" + std::to_string(counts[HS_BLOCK_RIGID]) +
                     " rigid, " + std::to_string(counts[HS_BLOCK_FIXED]) + " fixed, " +
                     std::to_string(counts[HS_BLOCK_PRESCRIBED]) + " prescribed";
  if (counts[HS_BLOCK_AFFINE] > 0) text += ", " + std::to_string(counts[HS_BLOCK_AFFINE]) + " affine";
  if (counts[HS_BLOCK_MESH] > 0) {
    text += ", " + std::to_string(counts[HS_BLOCK_MESH]) + " cells of " +
            std::to_string(layout.bodies.size()) + (layout.bodies.size() == 1 ? " mesh" : " meshes");
  }
  text += ')';
  if (!layout.compounds.empty()) {
    std::size_t parts = 0;
    for (const LayoutCompound& compound : layout.compounds) parts += compound.part_count;
    text += "; " + std::to_string(parts) + " of them parts of " + std::to_string(layout.compounds.size()) +
            (layout.compounds.size() == 1 ? " concave block" : " concave blocks");
  }
  const auto excavated = std::count_if(end.blocks.begin(), end.blocks.end(), is_removed);
  if (excavated > 0) text += "; " + std::to_string(excavated) + " of them excavated";
  if (layout.left_out > 0) {
    text += "; " + std::to_string(layout.left_out) + " left out as too small, " +
            rounded(layout.size_left_out, 3) + (layout.dimension == 3 ? " m3 in all" : " m2 in all");
  }
  return text;
}

const char* describe(Outcome outcome) {
  switch (outcome) {
    case Outcome::complete:
      return "complete";
    case Outcome::at_rest:
      return "complete: at rest before the end";
    case Outcome::interrupted:
      return "interrupted";
    case Outcome::unstable:
      return "UNSTABLE: the next step could not be made";
    case Outcome::too_fast:
      return "REFUSED: two blocks are too fast for the time step";
  }
  return "";
}

constexpr double usual_residual = 0.01;  ///< of the released energy

double released_energy(const hs_world_report& report, double fracture_loss) {
  const hs_energy& energy = report.energy;
  return fracture_loss + report.impact_loss + report.bolt_loss + report.block_strain_energy +
         report.block_damping_loss + energy.kinetic + energy.strain + energy.friction_loss +
         energy.contact_damping_loss + energy.local_damping_loss + energy.mass_damping_loss;
}

/// An energy that can be rounding errors of the ledger's sums, over many steps.
double rounding_energy(const hs_world_report& report, double released) {
  constexpr double rounding = 1e-9;
  return rounding * (std::abs(report.energy.gravity) + std::abs(report.energy.outer_work) +
                     std::abs(report.water_energy) + std::abs(released));
}

std::string energy_text(const hs_world_report& report, double released) {
  const double residual = report.energy.residual;
  const std::string text = rounded(residual, 3) + " J";
  if (!(released > 0)) return text;
  const std::string scale = " the " + rounded(released, 4) + " J released";
  if (std::abs(residual) > usual_residual * released &&
      std::abs(residual) <= rounding_energy(report, released))
    return text + ", rounding errors beside" + scale;
  return text + ", " + rounded(residual / released, 2) + " of" + scale;
}

/// Empty without bonds.
std::string bonds_text(const Scene& scene, const hs_bond_report& bonds) {
  if (scene.bonds.empty()) return {};
  std::string text = std::to_string(bonds.bond_count) + " made, " +
                     std::to_string(bonds.bond_count - bonds.joint_count) + " broken; cracks of " +
                     rounded(bonds.crack_area, 4) + (scene.world.dimension == 3 ? " m2" : " m");
  if (bonds.event_count > 0) text += ", fracture energy " + rounded(bonds.fracture_loss, 4) + " J";
  return report_line("bonds", text);
}

/// Empty without bolts.
std::string bolts_text(const Scene& scene, const hs_world_report& report, const Frame& end) {
  if (scene.bolts.empty()) return {};
  double largest = 0;
  std::int64_t ruptured = 0, yielded = 0;
  for (const hs_bolt& bolt : end.bolts) {
    largest = std::max(largest, bolt.tension);
    ruptured += bolt.is_ruptured;
    yielded += bolt.is_ruptured == 0 && bolt.plastic_elongation != 0;
  }
  return report_line("bolts", std::to_string(end.bolts.size()) + " installed, " + std::to_string(yielded) +
                                  " yielded, " + std::to_string(ruptured) + " ruptured; largest tension " +
                                  rounded(largest, 4) + " N, loss " + rounded(report.bolt_loss, 4) + " J");
}

/// Empty without contacts of blocks without springs.
std::string impacts_text(const hs_world_report& report) {
  if (report.touch_count == 0) return {};
  return report_line("touches", std::to_string(report.touch_count) + " without a spring, impact loss " +
                                    rounded(report.impact_loss, 4) + " J");
}

/// Empty if the time step was stable all the time.
std::string time_step_text(const hs_world_report& report, const Peaks& peaks) {
  if (report.time_step <= peaks.stable_time_step) return {};
  return report_line("time step", "above the stable one, min " + rounded(peaks.stable_time_step, 4) + " s");
}

/// Empty if blocks are slow enough for the step and the springs.
std::string fast_blocks_text(const hs_world_report& report, const Peaks& peaks) {
  constexpr double reported_ratio = 0.1;
  std::string text;
  if (report.divided_steps > 0) {
    text +=
        report_line("divided steps", std::to_string(report.divided_steps) + ", at impacts or fast rotations");
  }
  if (peaks.penetration_ratio > reported_ratio) {
    text +=
        report_line("softest springs", "allow a penetration of " + rounded(100 * peaks.penetration_ratio, 3) +
                                           " % of the thinner one's thickness");
  }
  return text;
}

/// Empty if no block may sleep.
std::string sleep_text(const Scene& scene, const hs_world_report& report) {
  if (scene.world.sleep_tolerance == 0) return {};
  return report_line("asleep", std::to_string(report.sleeping_count) + " of " +
                                   std::to_string(report.block_count) +
                                   " blocks at the end; max displacement error by sleep " +
                                   rounded(report.max_sleep_error, 2) + " m");
}

std::string run_out_text(const RunOut& reach, int dimension) {
  const auto metres = [](double length) { return decimals(length, 2) + " m "; };
  std::string text =
      metres(reach.forwards[0]) + "to the right, " + metres(reach.backwards[0]) + "to the left";
  if (dimension == 3) {
    text = metres(reach.forwards[0]) + "towards +x, " + metres(reach.backwards[0]) + "towards -x, " +
           metres(reach.forwards[1]) + "towards +y, " + metres(reach.backwards[1]) + "towards -y";
  }
  return text + "; " + decimals(100 * reach.moved_out, 1) + " % of the mass beyond its initial extent";
}

}  // namespace

std::string scene_lines(const Scene& scene) {
  return report_line("scene", scene.title) +
         (scene.settings.empty() ? std::string() : report_line("set", scene.settings));
}

std::string negative_losses_text(const hs_world_report& report, double fracture_loss) {
  const hs_energy& energy = report.energy;
  const double rounding = rounding_energy(report, released_energy(report, fracture_loss));
  // Friction does work in an impact, so that only both losses together are above zero.
  const struct {
    const char* name;
    double loss;
  } entries[] = {{report.impact_loss == 0 ? "friction" : "friction and impacts",
                  energy.friction_loss + report.impact_loss},
                 {"contact damping", energy.contact_damping_loss},
                 {"local damping", energy.local_damping_loss},
                 {"mass damping", energy.mass_damping_loss},
                 {"block damping", report.block_damping_loss}};
  std::string text;
  double created = energy.residual;
  for (const auto& entry : entries) {
    if (entry.loss >= -rounding) continue;
    created -= entry.loss;
    text += report_line("ENERGY CREATED", std::string("the loss by ") + entry.name + " is " +
                                              rounded(entry.loss, 3) + " J, below zero");
  }
  return created > rounding ? text : std::string();
}

std::string residual_note(const hs_world_report& report, double fracture_loss) {
  const double residual = report.energy.residual, released = released_energy(report, fracture_loss);
  if (!(std::abs(residual) >
        std::max(usual_residual * std::abs(released), rounding_energy(report, released))))
    return {};
  return "note: energy residual: the numerical method has " +
         std::string(residual > 0 ? "created " : "lost ") + rounded(std::abs(residual / released), 2) +
         " of the energy released; usual: below 0.01, at a shorter time_step\n";
}

RunOut run_out(const Frame& start, const Frame& end, int dimension) {
  const std::size_t horizontal_axes = dimension == 3 ? 2 : 1;
  const Extent first = extent_of(start, end);
  const Extent last = extent_of(end, end);
  if (!(first.low[0] <= first.high[0] && last.low[0] <= last.high[0])) return {};  // none moves freely
  RunOut result;
  for (std::size_t axis = 0; axis < horizontal_axes; ++axis) {
    result.forwards[axis] = last.high[axis] - first.high[axis];
    result.backwards[axis] = first.low[axis] - last.low[axis];
  }
  double mass = 0;
  for (const BlockFrame& block : end.blocks) {
    if (!moves_freely(block.state.kind)) continue;
    mass += block.state.mass;
    if (!first.holds(block.state.pose.position, horizontal_axes)) result.moved_out += block.state.mass;
  }
  result.moved_out /= mass;
  return result;
}

RunFigures figures_of(const Model& model, const Peaks& peaks, const Frame& start, const Frame& end) {
  RunFigures figures{.run_out = run_out(start, end, model.layout().dimension).farthest(),
                     .largest_overlap = peaks.overlap,
                     .energy_residual = model.report().energy.residual};
  for (std::size_t i = 0; i < end.blocks.size(); ++i) {
    if (!moves_freely(end.blocks[i].state.kind)) continue;
    const double moved = length(
        minus(point_of(end.blocks[i].state.pose.position), point_of(start.blocks[i].state.pose.position)));
    figures.max_displacement = std::max(figures.max_displacement, moved);
  }
  return figures;
}

std::string summary(const Scene& scene, const Model& model, const Peaks& peaks, const Frame& start,
                    const Frame& end, Outcome outcome) {
  const hs_world_report& report = model.report();
  const hs_bond_report bonds = model.bond_report();
  const RunOut reach = run_out(start, end, scene.world.dimension);
  return scene_lines(scene) + report_line("outcome", describe(outcome)) +
         report_line("blocks", blocks_text(model.layout(), end)) +
         report_line("simulated", rounded(report.time, 6) + " s in " + std::to_string(report.steps) +
                                      " steps of " + rounded(report.time_step, 4) +
                                      " s (stable: " + rounded(report.stable_time_step, 4) + " s)") +
         report_line("contacts", std::to_string(report.contact_count) + " at the end, largest overlap " +
                                     rounded(report.largest_overlap, 3) + " m, fastest block " +
                                     rounded(report.largest_speed, 3) + " m/s") +
         report_line("in the whole run", "largest overlap " + rounded(peaks.overlap, 3) +
                                             " m, fastest block " + rounded(report.peak_speed, 3) + " m/s") +
         time_step_text(report, peaks) + fast_blocks_text(report, peaks) + sleep_text(scene, report) +
         (report.potential_length > 0
              ? report_line("potential length", rounded(report.potential_length, 6) + " m")
              : std::string()) +
         bonds_text(scene, bonds) + bolts_text(scene, report, end) + impacts_text(report) +
         report_line("energy residual", energy_text(report, released_energy(report, bonds.fracture_loss))) +
         negative_losses_text(report, bonds.fracture_loss) +
         report_line("run-out", run_out_text(reach, scene.world.dimension));
}

std::string timings(const hs_world_report& report, std::int64_t steps, double seconds) {
  const double block_steps = static_cast<double>(report.block_count) * static_cast<double>(steps);
  return report_line("wall time", decimals(seconds, 2) + " s, " + rounded(block_steps / seconds, 3) +
                                      " block-steps per second, output included");
}

}  // namespace halfspace::cli
