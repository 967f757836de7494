#pragma once

#include <cstdint>
#include <vector>

#include "picture/colour.h"
#include "scene.h"

namespace halfspace::cli {

/// Pixels row by row from above, three bytes each.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
};

/// Draws the faces of solids so that the nearer hide the farther, by a depth for each of several samples of a
/// pixel. Where two faces border on each other, or on nothing, a dark line is drawn.
class Canvas {
 public:
  static constexpr int samples = 3;  ///< of a pixel in each direction

  /// In pixels.
  Canvas(int width, int height);

  /// A convex face, in pixels to the right and downwards, its third coordinate larger the nearer it is. Only
  /// faces that run clockwise as seen (counter-clockwise from outside, y upwards) show their outside; others
  /// are not drawn.
  void draw(const std::vector<Point>& corners, Rgb colour);

  /// What was drawn, on white, with lines so many samples wide.
  Image image(int line_width) const;

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  /// Does another face begin within a line's width to the right or below?
  bool on_line(int column, int row, int line_width) const;

  int columns_;
  int rows_;
  std::vector<float> depths_;
  std::vector<std::int32_t> faces_;  ///< index of the face at each sample, -1 for none
  std::vector<Rgb> colours_;         ///< of each face
};

}  // namespace halfspace::cli
