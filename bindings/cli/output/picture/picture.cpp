#include "output/picture/picture.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"
#include "output/picture/plot.h"
#include "output/picture/svg.h"

namespace halfspace::cli {
namespace {

/// Above the plot, where no block is.
void draw_scale_bar(Svg& svg, const Plot& plot) {
  const double length = even_step(plot.stage.upper_right[0] - plot.stage.lower_left[0], 8);
  const double left = plot.right() - plot.scale * length;
  svg.rectangle({left, 38}, plot.scale * length, 5, "fill=\"#222\"");
  svg.label({left - 8, 44}, decimals(length, decimals_for(length)) + " m", 13, "end");
}

/// Draws bolts over the blocks, as most of each is inside of them; dashed once they are ruptured.
void draw_bolts(Svg& svg, const Plot& plot, const Frame& frame) {
  if (frame.bolts.empty()) return;
  svg.begin_clip(plot.corner(), plot.width, plot.height);
  for (const hs_bolt& bolt : frame.bolts) {
    std::string style = "stroke=\"#7d3c98\" stroke-width=\"2.5\"";
    if (bolt.is_ruptured != 0) style += " stroke-dasharray=\"4 3\"";
    const auto at = [&](const double* place) { return plot.at(shown(plot.stage, point_of(place))); };
    svg.line(at(bolt.place_a), at(bolt.place_b), style);
  }
  svg.end_clip();
}

void draw_colours(Svg& svg, const Plot& plot, const Scene& scene) {
  const Stage& stage = plot.stage;
  const double x = plot.right() + 22;
  const double height = std::min(plot.height, 240.0);
  if (stage.colour == Colour::material) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      const double y = top_margin + 22 * static_cast<double>(i);
      svg.rectangle({x, y}, 14, 14,
                    "fill=\"" + hex(ramp_colour(colour_position(stage, static_cast<double>(i)))) + '"');
      svg.label({x + 20, y + 12}, scene.materials[i].name, 12, "start");
    }
    return;
  }
  const int bands = stage.colour == Colour::layer ? stage.layers : 48;
  for (int i = 0; i < bands; ++i) {
    const double value = stage.lowest + (stage.highest - stage.lowest) * (i + 0.5) / bands;
    const double y = top_margin + height * (bands - 1 - i) / bands;
    svg.rectangle({x, y}, 14, height / bands + 0.3,
                  "fill=\"" + hex(ramp_colour(colour_position(stage, value))) + '"');
  }
  svg.rectangle({x, top_margin}, 14, height, "fill=\"none\" stroke=\"#222\" stroke-width=\"0.8\"");
  const double range = stage.highest - stage.lowest;
  constexpr double digit_width = 6.7;
  double widest = 0;  // of the numbers
  if (range > 0) {
    const double step = even_step(range, 5);
    for (const double value : multiples_of(step, stage.lowest, stage.highest)) {
      const double y = top_margin + height * (stage.highest - value) / range;
      svg.line({x + 14, y}, {x + 18, y}, "stroke=\"#222\"");
      const std::string number = number_on_scale(value, step, stage.lowest, stage.highest);
      widest = std::max(widest, digit_width * static_cast<double>(number.size()));
      svg.label({x + 22, y + 4}, number, 12, "start");
    }
  }
  const char* meaning = "displacement (m)";
  if (stage.colour == Colour::speed) meaning = "speed (m/s)";
  if (stage.colour == Colour::mean_stress) meaning = "mean stress (MPa)";
  if (stage.colour == Colour::layer) meaning = "height at start (m)";
  svg.label({x + std::max(74.0, 38 + widest), top_margin + height / 2}, meaning, 13, "middle", -90);
}

}  // namespace

void draw_number(Svg& svg, std::size_t block, const Point& middle, double area) {
  constexpr double largest = 12;
  const std::string number = std::to_string(block);
  // A digit is about half as wide as high. Numbers too small to read are left to the zoom of the viewer.
  const double size =
      std::min(largest, 1.2 * std::sqrt(area) / static_cast<double>(std::max<std::size_t>(number.size(), 2)));
  svg.label({middle[0], middle[1] + 0.35 * size}, number, size, "middle");
}

std::string picture(const Stage& stage, const Scene& scene, const Layout& layout, const Frame& start,
                    const Frame& frame) {
  const Plot plot(stage);
  const double width = std::max(plot.right() + right_margin, 420.0);
  const double height = std::max(plot.bottom(), top_margin + 240.0) + bottom_margin;
  Svg svg(width, height);
  svg.rectangle({0, 0}, width, height, "fill=\"#ffffff\"");
  svg.label({left_margin, 24}, stage.title, 17, "start");
  svg.label({left_margin, 44}, "t = " + decimals(frame.time, 3) + " s", 14, "start");
  if (stage.dimension == 2) {
    draw_in_plane(svg, plot, layout, start, frame);
  } else {
    draw_in_space(svg, plot, layout, start, frame);
  }
  draw_bolts(svg, plot, frame);
  draw_scale_bar(svg, plot);
  draw_colours(svg, plot, scene);
  return svg.text();
}

}  // namespace halfspace::cli
