#include <algorithm>
#include <cmath>

#include "common/text.h"
#include "common/vector.h"
#include "output/picture/plot.h"

namespace halfspace::cli {
namespace {

double largest_force(const Frame& frame) {
  double largest = 0;
  for (const hs_contact& contact : frame.contacts)
    largest = std::max(largest, std::abs(contact.normal_force));
  return largest;
}

void draw_blocks(Svg& svg, const Plot& plot, const Frame& start, const Frame& frame) {
  const std::string pen =
      " stroke-width=\"" + decimals(outline_width(plot, frame), 2) + "\" stroke-linejoin=\"round\"";
  svg.begin_clip(plot.corner(), plot.width, plot.height);
  for (std::size_t i = 0; i < frame.blocks.size(); ++i) {
    const BlockFrame& block = frame.blocks[i];
    if (block.vertices.empty()) continue;  // it has been excavated
    std::vector<Point> outline_points;
    for (const Point& p : block.vertices) outline_points.push_back(plot.at(p));
    const char* stroke = "#8a867e";
    if (block.state.kind == HS_BLOCK_PRESCRIBED) stroke = "#6f6b64";
    if (moves_freely(block.state.kind)) stroke = "#1b1b1b";
    const std::string fill = hex(colour_of(plot.stage, start.blocks[i], block));
    svg.polygon(outline_points, "fill=\"" + fill + "\" stroke=\"" + stroke + '"' + pen);
  }
  svg.end_clip();
}

void draw_numbers(Svg& svg, const Plot& plot, const Frame& frame) {
  svg.begin_clip(plot.corner(), plot.width, plot.height);
  for (std::size_t i = 0; i < frame.blocks.size(); ++i) {
    const BlockFrame& block = frame.blocks[i];
    if (block.vertices.empty()) continue;  // it has been excavated
    draw_number(svg, i, plot.at(point_of(block.state.pose.position)),
                plot.scale * plot.scale * length(area_normal(block.vertices)) / 2);
  }
  svg.end_clip();
}

/// Draws force chains: lines from centroid to centroid through the contact point, as wide as the force is
/// large.
void draw_forces(Svg& svg, const Plot& plot, const Frame& frame) {
  constexpr double widest_line = 7, min_width = 0.15;
  const double largest = largest_force(frame);
  if (!(largest > 0)) return;
  svg.begin_clip(plot.corner(), plot.width, plot.height);
  for (const hs_contact& contact : frame.contacts) {
    const double width = widest_line * std::abs(contact.normal_force) / largest;
    if (width < min_width) continue;
    const std::string style = std::string("stroke=\"") + (contact.normal_force > 0 ? "#c0392b" : "#2c6fbb") +
                              "\" stroke-linecap=\"round\" stroke-width=\"" + decimals(width, 2) + '"';
    const Point middle = plot.at(point_of(contact.force_point));
    for (const std::uint64_t block : {contact.block_a, contact.block_b}) {
      const BlockFrame& end = frame.blocks[block];
      // No line to the centroid of a boundary.
      if (moves_freely(end.state.kind)) svg.line(middle, plot.at(point_of(end.state.pose.position)), style);
    }
  }
  svg.end_clip();
  // Below the title of the axis where the plot is too narrow for both.
  const double down = plot.width < 700 ? 55 : 44;
  svg.label({plot.right(), plot.bottom() + down},
            "widest line: " + rounded(largest, 3) + " N per metre of thickness", 12, "end");
}

/// Draws the water table over the blocks, level beyond its ends.
void draw_water(Svg& svg, const Plot& plot, const Frame& frame) {
  if (frame.water.empty()) return;
  std::vector<Point> table = frame.water;
  table.insert(table.begin(), {std::min(plot.stage.lower_left[0], table.front()[0]), table.front()[1]});
  table.push_back({std::max(plot.stage.upper_right[0], table.back()[0]), table.back()[1]});
  svg.begin_clip(plot.corner(), plot.width, plot.height);
  for (std::size_t i = 1; i < table.size(); ++i)
    svg.line(plot.at(table[i - 1]), plot.at(table[i]), "stroke=\"#1f78d1\" stroke-width=\"1.8\"");
  svg.end_clip();
}

void draw_axis(Svg& svg, const Plot& plot, int axis) {
  const double low = plot.stage.lower_left[axis];
  const double high = plot.stage.upper_right[axis];
  const double length = plot.scale * (high - low);
  const double step = even_step(high - low, std::max(2, static_cast<int>(length / 75)));
  const int digits = decimals_for(step);
  for (const double value : multiples_of(step, low, high + 1e-9 * step)) {
    const std::string text = decimals(value + 0.0, digits);
    if (axis == 0) {
      const double x = plot.at({value, 0})[0];
      svg.line({x, plot.bottom()}, {x, plot.bottom() + 5}, "stroke=\"#222\"");
      svg.label({x, plot.bottom() + 20}, text, 13, "middle");
    } else {
      const double y = plot.at({0, value})[1];
      svg.line({left_margin - 5, y}, {left_margin, y}, "stroke=\"#222\"");
      svg.label({left_margin - 9, y + 4.5}, text, 13, "end");
    }
  }
  if (axis == 0) {
    svg.label({left_margin + plot.width / 2, plot.bottom() + 44}, "x (m)", 14, "middle");
  } else {
    svg.label({left_margin - 50, top_margin + plot.height / 2}, "y (m)", 14, "middle", -90);
  }
}

}  // namespace

void draw_in_plane(Svg& svg, const Plot& plot, const Layout& layout, const Frame& start, const Frame& frame) {
  draw_blocks(svg, plot, start, frame);
  draw_water(svg, plot, frame);
  if (plot.stage.open_joints) draw_open_joints(svg, plot, layout, start, frame);
  if (plot.stage.thrust) draw_thrust(svg, plot, frame);
  if (plot.stage.forces) draw_forces(svg, plot, frame);
  if (plot.stage.numbers) draw_numbers(svg, plot, frame);
  svg.rectangle(plot.corner(), plot.width, plot.height, "fill=\"none\" stroke=\"#222\"");
  draw_axis(svg, plot, 0);
  draw_axis(svg, plot, 1);
}

}  // namespace halfspace::cli
