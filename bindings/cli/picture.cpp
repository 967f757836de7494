#include "picture.h"

#include <algorithm>
#include <cmath>

#include "svg.h"
#include "text.h"

namespace halfspace::cli {
namespace {

constexpr double left_margin = 72, right_margin = 116, top_margin = 56, bottom_margin = 58;
constexpr double widest = 840, tallest = 640;

/// The value that a block's colour shows.
double value_of(Colour colour, const BlockFrame& then, const BlockFrame& now) {
  const auto& position = now.state.pose.position;
  const auto& origin = then.state.pose.position;
  switch (colour) {
    case Colour::displacement:
      return std::hypot(position[0] - origin[0], position[1] - origin[1]);
    case Colour::speed:
      return std::hypot(now.state.velocity[0], now.state.velocity[1]);
    case Colour::layer:
      return origin[1];
    case Colour::material:
      return now.state.material;
  }
  return 0;
}

struct Bounds {
  Point low{INFINITY, INFINITY};
  Point high{-INFINITY, -INFINITY};

  void add(const BlockFrame& block) {
    for (const Point& p : block.vertices) {
      for (int axis : {0, 1}) {
        low[axis] = std::min(low[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
    }
  }
};

/// Around everything that moves; of fixed blocks only what lies near it is worth the paper.
Bounds bounds_of(const Frame& start, const Frame& end) {
  const auto around = [&](auto&& counts) {
    Bounds bounds;
    for (const Frame* frame : {&start, &end}) {
      for (const BlockFrame& block : frame->blocks) {
        if (counts(block.state.kind)) bounds.add(block);
      }
    }
    return bounds;
  };
  const Bounds moving = around([](int kind) { return kind == HS_BLOCK_RIGID; });
  return std::isfinite(moving.low[0]) ? moving : around([](int) { return true; });
}

/// Maps the world to pixels.
struct Plot {
  explicit Plot(const Stage& stage) : stage(stage) {
    const double w = stage.upper_right[0] - stage.lower_left[0];
    const double h = stage.upper_right[1] - stage.lower_left[1];
    scale = std::min(widest / w, tallest / h);
    width = scale * w;
    height = scale * h;
  }
  Point at(Point p) const {
    return {left_margin + scale * (p[0] - stage.lower_left[0]),
            top_margin + scale * (stage.upper_right[1] - p[1])};
  }
  Point corner() const { return {left_margin, top_margin}; }
  double right() const { return left_margin + width; }
  double bottom() const { return top_margin + height; }

  const Stage& stage;
  double scale, width, height;
};

double share_of(const Stage& stage, double value) {
  const double range = stage.highest - stage.lowest;
  double share = range > 0 ? std::clamp((value - stage.lowest) / range, 0.0, 1.0) : 0;
  if (stage.colour != Colour::layer || stage.layers < 2) return share;
  const int layer = std::min(static_cast<int>(share * stage.layers), stage.layers - 1);
  return static_cast<double>(layer) / (stage.layers - 1);
}

void draw_blocks(Svg& svg, const Plot& plot, const Frame& start, const Frame& frame) {
  double area = 0;
  int count = 0;
  for (const BlockFrame& block : frame.blocks) {
    if (block.state.kind != HS_BLOCK_RIGID) continue;
    Bounds bounds;
    bounds.add(block);
    area += (bounds.high[0] - bounds.low[0]) * (bounds.high[1] - bounds.low[1]);
    ++count;
  }
  // Outlines as thin as small blocks need, so that their colour is still seen.
  const double typical_size = count > 0 ? plot.scale * std::sqrt(area / count) : 10;
  const double outline = std::clamp(0.04 * typical_size, 0.1, 0.8);
  const std::string pen = " stroke-width=\"" + decimals(outline, 2) + "\" stroke-linejoin=\"round\"";
  svg.begin_clip(plot.corner(), plot.width, plot.height);
  for (std::size_t i = 0; i < frame.blocks.size(); ++i) {
    const BlockFrame& block = frame.blocks[i];
    std::vector<Point> outline_points;
    for (const Point& p : block.vertices) outline_points.push_back(plot.at(p));
    std::string paint = "fill=\"#d6d3cd\" stroke=\"#8a867e\"";
    if (block.state.kind == HS_BLOCK_PRESCRIBED) paint = "fill=\"#b9b4ab\" stroke=\"#6f6b64\"";
    if (block.state.kind == HS_BLOCK_RIGID) {
      const double value = value_of(plot.stage.colour, start.blocks[i], block);
      paint = "fill=\"" + ramp_colour(share_of(plot.stage, value)) + "\" stroke=\"#1b1b1b\"";
    }
    svg.polygon(outline_points, paint + pen);
  }
  svg.end_clip();
}

void draw_axis(Svg& svg, const Plot& plot, int axis) {
  const double low = plot.stage.lower_left[axis];
  const double high = plot.stage.upper_right[axis];
  const double length = plot.scale * (high - low);
  const double step = even_step(high - low, std::max(2, static_cast<int>(length / 75)));
  const int digits = decimals_for(step);
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
    const double value = k * step;
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

void draw_scale_bar(Svg& svg, const Plot& plot) {
  const double length = even_step(plot.stage.upper_right[0] - plot.stage.lower_left[0], 8);
  const double right = plot.right() - 16;
  const double y = top_margin + 34;
  svg.rectangle({right - plot.scale * length, y}, plot.scale * length, 5, "fill=\"#222\"");
  svg.label({right - plot.scale * length / 2, y - 6}, decimals(length, decimals_for(length)) + " m", 13,
            "middle");
}

void draw_colours(Svg& svg, const Plot& plot, const Scene& scene) {
  const Stage& stage = plot.stage;
  const double x = plot.right() + 22;
  const double height = std::min(plot.height, 240.0);
  if (stage.colour == Colour::material) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      const double y = top_margin + 22 * static_cast<double>(i);
      svg.rectangle({x, y}, 14, 14, "fill=\"" + ramp_colour(share_of(stage, static_cast<double>(i))) + '"');
      svg.label({x + 20, y + 12}, scene.materials[i].name, 12, "start");
    }
    return;
  }
  const int bands = stage.colour == Colour::layer ? stage.layers : 48;
  for (int i = 0; i < bands; ++i) {
    const double value = stage.lowest + (stage.highest - stage.lowest) * (i + 0.5) / bands;
    const double y = top_margin + height * (bands - 1 - i) / bands;
    svg.rectangle({x, y}, 14, height / bands + 0.3, "fill=\"" + ramp_colour(share_of(stage, value)) + '"');
  }
  svg.rectangle({x, top_margin}, 14, height, "fill=\"none\" stroke=\"#222\" stroke-width=\"0.8\"");
  const double range = stage.highest - stage.lowest;
  if (range > 0) {
    const double step = even_step(range, 5);
    for (double k = std::ceil(stage.lowest / step - 1e-9); k * step <= stage.highest; ++k) {
      const double y = top_margin + height * (stage.highest - k * step) / range;
      svg.line({x + 14, y}, {x + 18, y}, "stroke=\"#222\"");
      svg.label({x + 22, y + 4}, decimals(k * step + 0.0, decimals_for(step)), 12, "start");
    }
  }
  const char* meaning = "displacement (m)";
  if (stage.colour == Colour::speed) meaning = "speed (m/s)";
  if (stage.colour == Colour::layer) meaning = "height at start (m)";
  svg.label({x + 74, top_margin + height / 2}, meaning, 13, "middle", -90);
}

}  // namespace

Stage stage_for(const Scene& scene, const Frame& start, const Frame& end) {
  Stage stage{.title = scene.title, .colour = scene.output.colour, .layers = scene.output.layers};
  if (scene.output.window) {
    stage.lower_left = (*scene.output.window)[0];
    stage.upper_right = (*scene.output.window)[1];
  } else {
    const Bounds bounds = bounds_of(start, end);
    const double margin = 0.06 * std::max(bounds.high[0] - bounds.low[0], bounds.high[1] - bounds.low[1]);
    stage.lower_left = {bounds.low[0] - margin, bounds.low[1] - margin};
    stage.upper_right = {bounds.high[0] + margin, bounds.high[1] + margin};
  }
  double lowest = INFINITY;
  double highest = -INFINITY;
  for (const Frame* frame : {&start, &end}) {
    for (std::size_t i = 0; i < frame->blocks.size(); ++i) {
      if (frame->blocks[i].state.kind != HS_BLOCK_RIGID) continue;
      const double value = value_of(stage.colour, start.blocks[i], frame->blocks[i]);
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  }
  if (lowest <= highest) {
    stage.lowest = lowest;
    stage.highest = highest;
  }
  return stage;
}

std::string picture(const Stage& stage, const Scene& scene, const Frame& start, const Frame& frame) {
  const Plot plot(stage);
  const double width = std::max(plot.right() + right_margin, 420.0);
  const double height = std::max(plot.bottom(), top_margin + 240.0) + bottom_margin;
  Svg svg(width, height);
  svg.rectangle({0, 0}, width, height, "fill=\"#ffffff\"");
  svg.label({left_margin, 24}, stage.title, 17, "start");
  svg.label({left_margin, 44}, "t = " + decimals(frame.time, 3) + " s", 14, "start");
  draw_blocks(svg, plot, start, frame);
  svg.rectangle(plot.corner(), plot.width, plot.height, "fill=\"none\" stroke=\"#222\"");
  draw_axis(svg, plot, 0);
  draw_axis(svg, plot, 1);
  draw_scale_bar(svg, plot);
  draw_colours(svg, plot, scene);
  return svg.text();
}

}  // namespace halfspace::cli
