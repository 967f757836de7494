#include "output/picture/stage.h"

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

/// The value that the colour of a block shows.
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

/// The bounds of the eight corners of a window (in 2D four).
Bounds bounds_of(const Stage& stage, const std::array<Point, 2>& window) {
  Bounds bounds;
  for (std::size_t corner = 0; corner < 8; ++corner)
    bounds.add(shown(stage, {window[corner & 1][0], window[corner >> 1 & 1][1], window[corner >> 2][2]}));
  return bounds;
}

/// The settings that values and bounds depend on.
std::string view_of(Output output) {
  Archive archive;
  std::vector<Point> window;
  if (output.window) window.assign(output.window->begin(), output.window->end());
  archive.add(output.colour);
  archive.add(window);
  archive.add(output.azimuth);
  archive.add(output.elevation);
  return archive.bytes();
}

bool is_free(const BlockFrame& block) { return moves_freely(block.state.kind); }

}  // namespace

/// Points beyond any valid coordinate are ignored.
void Bounds::add(const Point& p) {
  constexpr double farthest = 1e75;
  for (std::size_t axis : {0, 1})
    if (!(std::abs(p[axis]) <= farthest)) return;
  for (std::size_t axis : {0, 1}) {
    low[axis] = std::min(low[axis], p[axis]);
    high[axis] = std::max(high[axis], p[axis]);
  }
}

bool Bounds::have_an_area() const {
  const auto is_length = [](double length) { return length > 0 && std::isfinite(length); };
  return is_length(high[0] - low[0]) && is_length(high[1] - low[1]);
}

RunStage::RunStage(const Scene& scene, const Frame& origin)
    : stage_{.title = scene.title,
             .dimension = scene.world.dimension,
             .camera = Camera(scene.output.azimuth, scene.output.elevation),
             .colour = scene.output.colour,
             .layers = scene.output.layers,
             .forces = scene.output.forces,
             .numbers = scene.output.numbers,
             .open_joints = scene.output.open_joints,
             .thrust = scene.output.thrust},
      view_(view_of(scene.output)),
      origin_(&origin),
      has_window_(scene.output.window),
      has_free_(std::any_of(origin.blocks.begin(), origin.blocks.end(), is_free)) {
  if (has_window_) bounds_ = bounds_of(stage_, *scene.output.window);
}

void RunStage::reset_displacement(const Frame& origin) {
  if (stage_.colour != Colour::displacement) return;
  origin_ = &origin;
  lowest_ = INFINITY;
  highest_ = -INFINITY;
}

/// Fixed blocks do not extend the bounds, if any block is free.
void RunStage::add(const Frame& frame) {
  for (std::size_t i = 0; i < frame.blocks.size(); ++i) {
    const BlockFrame& block = frame.blocks[i];
    if (has_free_ && !is_free(block)) continue;
    if (!has_window_) add_to_bounds(block);
    if (!is_free(block)) continue;
    const double value = value_of(stage_, origin_->blocks[i], block);
    lowest_ = std::min(lowest_, value);
    highest_ = std::max(highest_, value);
  }
}

void RunStage::add_to_bounds(const BlockFrame& block) {
  for (const Point& p : block.vertices) bounds_.add(shown(stage_, p));
}

bool RunStage::add_to(Archive& archive) {
  std::string view = view_;
  Bounds bounds = bounds_;
  double lowest = lowest_, highest = highest_;
  archive.add(view);
  archive.add(bounds);
  archive.add(lowest);
  archive.add(highest);
  const bool has_values = std::isfinite(lowest) && std::isfinite(highest) && lowest <= highest;
  archive.require(bounds.have_an_area() && (has_values || (lowest == INFINITY && highest == -INFINITY)),
                  "invalid bounds of its pictures");
  if (view != view_) return false;
  bounds_ = bounds;
  lowest_ = lowest;
  highest_ = highest;
  return true;
}

Stage RunStage::stage() const {
  Stage stage = stage_;
  const double margin_ratio = has_window_ ? 0 : 0.06;
  const double margin =
      margin_ratio * std::max(bounds_.high[0] - bounds_.low[0], bounds_.high[1] - bounds_.low[1]);
  stage.lower_left = {bounds_.low[0] - margin, bounds_.low[1] - margin};
  stage.upper_right = {bounds_.high[0] + margin, bounds_.high[1] + margin};
  if (lowest_ <= highest_) {
    stage.lowest = lowest_;
    stage.highest = highest_;
  }
  return stage;
}

double colour_position(const Stage& stage, double value) {
  // An infinite value has no position.
  const double range = stage.highest - stage.lowest, part = (value - stage.lowest) / range;
  const double position = range > 0 && part > 0 ? std::min(part, 1.0) : 0;
  if (stage.colour != Colour::layer || stage.layers < 2) return position;
  const int layer = std::min(static_cast<int>(position * stage.layers), stage.layers - 1);
  return static_cast<double>(layer) / (stage.layers - 1);
}

Rgb colour_of(const Stage& stage, const BlockFrame& then, const BlockFrame& now) {
  if (now.state.kind == HS_BLOCK_FIXED) return {0xd6, 0xd3, 0xcd};
  if (now.state.kind == HS_BLOCK_PRESCRIBED) return {0xb9, 0xb4, 0xab};
  return ramp_colour(colour_position(stage, value_of(stage, then, now)));
}

double typical_size(const Stage& stage, const Frame& frame) {
  double area = 0;
  int count = 0;
  for (const BlockFrame& block : frame.blocks) {
    if (!is_free(block)) continue;
    Bounds bounds;
    for (const Point& p : block.vertices) bounds.add(shown(stage, p));
    area += (bounds.high[0] - bounds.low[0]) * (bounds.high[1] - bounds.low[1]);
    ++count;
  }
  return count > 0 ? std::sqrt(area / count) : 0;
}

}  // namespace halfspace::cli
