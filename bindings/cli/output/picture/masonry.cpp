#include <algorithm>
#include <cmath>
#include <vector>

#include "common/text.h"
#include "common/vector.h"
#include "output/joints.h"
#include "output/picture/plot.h"

namespace halfspace::cli {
namespace {

struct Force {
  Point at{};
  double size = 0;
};

/// The contact forces on each block.
std::vector<std::vector<Force>> forces_on_blocks(const Frame& frame) {
  std::vector<std::vector<Force>> forces(frame.blocks.size());
  for (const hs_contact& contact : frame.contacts) {
    const Force force{point_of(contact.force_point), length(point_of(contact.force))};
    if (force.size > 0)
      for (const std::uint64_t block : {contact.block_a, contact.block_b}) forces[block].push_back(force);
  }
  return forces;
}

/// The mean of the points of application, by the sizes of the forces.
Point mean_of(const std::vector<Force>& forces) {
  Point sum{};
  double size = 0;
  for (const Force& force : forces) {
    sum = plus(sum, times(force.size, force.at));
    size += force.size;
  }
  return times(1 / size, sum);
}

}  // namespace

void draw_open_joints(Svg& svg, const Plot& plot, const Layout& layout, const Frame& start,
                      const Frame& frame) {
  constexpr double min_ratio = 1e-4;  // of an opening that is drawn, over the length of the joint
  constexpr const char* style =
      R"(fill="#c0392b" stroke="#c0392b" stroke-width="1.5" stroke-linejoin="round")";
  svg.begin_clip(plot.corner(), plot.width, plot.height);
  for (const Joint& joint : joints_of(layout, start)) {
    if (is_removed(frame.blocks[joint.a]) || is_removed(frame.blocks[joint.b])) continue;
    const JointSides sides = sides_of(joint, start, frame);
    if (sides.opening() < min_ratio * joint.size) continue;
    const std::size_t open = sides.gaps[0] > sides.gaps[1] ? 0 : 1, other = 1 - open;
    const auto along = [&](const std::vector<Point>& side, double part) {
      return plot.at(plus(side[open], times(part, minus(side[other], side[open]))));
    };
    // The part from the open end to the point where both sides meet.
    const double shut = std::min(sides.gaps[other], 0.0);
    const double part = sides.gaps[open] / (sides.gaps[open] - shut);
    svg.polygon(
        {along(sides.of_a, 0), along(sides.of_a, part), along(sides.of_b, part), along(sides.of_b, 0)},
        style);
  }
  svg.end_clip();
}

void draw_thrust(Svg& svg, const Plot& plot, const Frame& frame) {
  constexpr const char* style = R"(stroke="#d35400" stroke-linecap="round" stroke-width="2.2")";
  const std::vector<std::vector<Force>> forces = forces_on_blocks(frame);
  svg.begin_clip(plot.corner(), plot.width, plot.height);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (!moves_freely(frame.blocks[i].state.kind) || forces[i].size() < 2) continue;
    if (forces[i].size() == 2) {
      svg.line(plot.at(forces[i][0].at), plot.at(forces[i][1].at), style);
      continue;
    }
    const Point mean = plot.at(mean_of(forces[i]));
    for (const Force& force : forces[i]) svg.line(plot.at(force.at), mean, style);
  }
  svg.end_clip();
}

}  // namespace halfspace::cli
