#pragma once

#include <algorithm>

#include "output/picture/stage.h"
#include "output/picture/svg.h"

namespace halfspace::cli {

inline constexpr double left_margin = 72, right_margin = 116, top_margin = 56, bottom_margin = 58;
inline constexpr double widest = 840, tallest = 640;

/// Maps the view to the pixels of a drawing.
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

/// Width of block outlines in pixels: thin enough to show the colours of small blocks.
inline double outline_width(const Plot& plot, const Frame& frame) {
  const double size = typical_size(plot.stage, frame);
  return std::clamp(0.04 * (size > 0 ? plot.scale * size : 10), 0.1, 0.8);
}

/// Draws the number of a block in the middle of its picture, which covers an area in square pixels.
void draw_number(Svg& svg, std::size_t block, const Point& middle, double area);

/// The blocks of a frame in the plane, with the axes around them.
void draw_in_plane(Svg& svg, const Plot& plot, const Layout& layout, const Frame& start, const Frame& frame);

/// The open parts of the joints between rigid blocks in the plane.
void draw_open_joints(Svg& svg, const Plot& plot, const Layout& layout, const Frame& start,
                      const Frame& frame);

/// The thrust line in the plane: lines within each block between the points of application of its contact
/// forces, through their mean if there are more than two.
void draw_thrust(Svg& svg, const Plot& plot, const Frame& frame);

/// The blocks of a frame in space, shaded, with the directions of the axes.
void draw_in_space(Svg& svg, const Plot& plot, const Layout& layout, const Frame& start, const Frame& frame);

}  // namespace halfspace::cli
