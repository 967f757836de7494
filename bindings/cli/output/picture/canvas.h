#pragma once

#include <cstdint>
#include <vector>

#include "common/vector.h"
#include "output/picture/colour.h"

namespace halfspace::cli {

/// Pixels row by row from above, three bytes each.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
};

/// Rasterizes the faces of solids with a depth buffer, several samples per pixel. Dark lines separate faces
/// from each other and from the background.
class Canvas {
 public:
  static constexpr int samples = 3;  ///< of a pixel in each direction

  /// In pixels.
  Canvas(int width, int height);

  /// Draws a convex face: pixels to the right and downwards; the third coordinate increases towards the
  /// viewer. Back faces, which run counter-clockwise on the canvas as seen, are not drawn.
  /// @return true if it is drawn
  bool draw(const std::vector<Point>& corners, Rgb colour);

  /// The visible part of each face, in the order of drawing.
  struct Visible {
    std::int64_t samples = 0;
    Point sum{};  ///< of their positions, in pixels
  };
  std::vector<Visible> visible_parts() const;

  /// The image, on white, with lines so many samples wide.
  Image image(int line_width) const;

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  /// True if another face begins within a line's width to the right or below.
  bool on_line(int column, int row, int line_width) const;

  int columns_;
  int rows_;
  std::vector<float> depths_;
  std::vector<std::int32_t> faces_;  ///< index of the face at each sample, -1 for none
  std::vector<Rgb> colours_;         ///< of each face
};

}  // namespace halfspace::cli
