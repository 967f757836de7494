#include "picture/stage.h"

#include <algorithm>
#include <cmath>

namespace halfspace::cli {
namespace {

double distance(const double a[3], const double b[3]) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double mean_stress(const hs_deformation& deformation, int dimension) {
  const double* stress = deformation.stress;
  return (stress[0] + stress[4] + stress[8]) / dimension;
}

/// The value that a block's colour shows.
double value_of(const Stage& stage, const BlockFrame& then, const BlockFrame& now) {
  static constexpr double rest[3] = {};
  switch (stage.colour) {
    case Colour::displacement:
      return distance(now.state.pose.position, then.state.pose.position);
    case Colour::speed:
      return distance(now.state.velocity, rest);
    case Colour::layer:
      return then.state.pose.position[up_axis(stage.dimension)];
    case Colour::material:
      return now.state.material;
    case Colour::mean_stress:
      return mean_stress(now.deformation, stage.dimension) / 1e6;
  }
  return 0;
}

struct Bounds {
  Point low{INFINITY, INFINITY};
  Point high{-INFINITY, -INFINITY};

  void add(const Point& p) {
    for (std::size_t axis : {0, 1}) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  void add(const Stage& stage, const BlockFrame& block) {
    for (const Point& p : block.vertices) add(shown(stage, p));
  }
};

/// Around everything that moves; of fixed blocks only what lies near it is worth the paper.
Bounds bounds_of(const Stage& stage, const Frame& start, const Frame& end) {
  const auto around = [&](auto&& counts) {
    Bounds bounds;
    for (const Frame* frame : {&start, &end}) {
      for (const BlockFrame& block : frame->blocks) {
        if (counts(block.state.kind)) bounds.add(stage, block);
      }
    }
    return bounds;
  };
  const Bounds moving = around([](int kind) { return moves_freely(kind); });
  return std::isfinite(moving.low[0]) ? moving : around([](int) { return true; });
}

/// Around the eight corners of a window, four of which are the same in 2D.
Bounds bounds_of(const Stage& stage, const std::array<Point, 2>& window) {
  Bounds bounds;
  for (std::size_t corner = 0; corner < 8; ++corner)
    bounds.add(shown(stage, {window[corner & 1][0], window[corner >> 1 & 1][1], window[corner >> 2][2]}));
  return bounds;
}

void set_window(Stage& stage, const Bounds& bounds, double margin_share) {
  const double margin =
      margin_share * std::max(bounds.high[0] - bounds.low[0], bounds.high[1] - bounds.low[1]);
  stage.lower_left = {bounds.low[0] - margin, bounds.low[1] - margin};
  stage.upper_right = {bounds.high[0] + margin, bounds.high[1] + margin};
}

void set_range(Stage& stage, const Frame& start, const Frame& end) {
  double lowest = INFINITY;
  double highest = -INFINITY;
  for (const Frame* frame : {&start, &end}) {
    for (std::size_t i = 0; i < frame->blocks.size(); ++i) {
      if (!moves_freely(frame->blocks[i].state.kind)) continue;
      const double value = value_of(stage, start.blocks[i], frame->blocks[i]);
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  }
  if (lowest <= highest) {
    stage.lowest = lowest;
    stage.highest = highest;
  }
}

}  // namespace

Stage stage_for(const Scene& scene, const Frame& start, const Frame& end) {
  const Output& output = scene.output;
  Stage stage{.title = scene.title,
              .dimension = scene.world.dimension,
              .camera = Camera(output.azimuth, output.elevation),
              .colour = output.colour,
              .layers = output.layers};
  if (output.window) {
    set_window(stage, bounds_of(stage, *output.window), 0);
  } else {
    set_window(stage, bounds_of(stage, start, end), 0.06);
  }
  set_range(stage, start, end);
  return stage;
}

double share_of(const Stage& stage, double value) {
  const double range = stage.highest - stage.lowest;
  double share = range > 0 ? std::clamp((value - stage.lowest) / range, 0.0, 1.0) : 0;
  if (stage.colour != Colour::layer || stage.layers < 2) return share;
  const int layer = std::min(static_cast<int>(share * stage.layers), stage.layers - 1);
  return static_cast<double>(layer) / (stage.layers - 1);
}

Rgb colour_of(const Stage& stage, const BlockFrame& then, const BlockFrame& now) {
  if (now.state.kind == HS_BLOCK_FIXED) return {0xd6, 0xd3, 0xcd};
  if (now.state.kind == HS_BLOCK_PRESCRIBED) return {0xb9, 0xb4, 0xab};
  return ramp_colour(share_of(stage, value_of(stage, then, now)));
}

double typical_size(const Stage& stage, const Frame& frame) {
  double area = 0;
  int count = 0;
  for (const BlockFrame& block : frame.blocks) {
    if (!moves_freely(block.state.kind)) continue;
    Bounds bounds;
    bounds.add(stage, block);
    area += (bounds.high[0] - bounds.low[0]) * (bounds.high[1] - bounds.low[1]);
    ++count;
  }
  return count > 0 ? std::sqrt(area / count) : 0;
}

}  // namespace halfspace::cli
