#include <cmath>

#include "common/vector.h"
#include "output/picture/canvas.h"
#include "output/picture/plot.h"
#include "output/picture/png.h"
#include "recording/encoding.h"

namespace halfspace::cli {
namespace {

constexpr int density = 2;  ///< image pixels per drawing pixel, for print

/// The brightness of a face by its outer normal in the view. The light comes from the upper left, and is
/// fixed to the camera; 60 % of it is ambient.
double light_on(const Point& normal) {
  constexpr Point towards_light{-0.42, 0.74, 0.53};
  const double facing = dot(normal, towards_light) / length(normal);
  return 0.6 + 0.4 * std::max(facing, 0.0);
}

/// Draws a block. @return the number of its faces that are drawn
std::size_t draw_block(Canvas& canvas, const Plot& plot, const std::vector<std::vector<int>>& faces,
                       const std::vector<Point>& vertices, Rgb colour) {
  std::size_t drawn = 0;
  std::vector<Point> seen;
  for (const Point& p : vertices) seen.push_back(shown(plot.stage, p));
  for (const std::vector<int>& face : faces) {
    std::vector<Point> corners;
    std::vector<Point> pixels;
    for (int vertex : face) {
      const Point& p = corners.emplace_back(seen[static_cast<std::size_t>(vertex)]);
      const Point at = plot.at(p);
      pixels.push_back({density * (at[0] - left_margin), density * (at[1] - top_margin), p[2]});
    }
    drawn += canvas.draw(pixels, lit(colour, light_on(area_normal(corners))));
  }
  return drawn;
}

/// Draws the number of each block in the middle of its visible part. The canvas has all faces of a block one
/// after another; `faces_of` has their numbers.
void draw_numbers(Svg& svg, const Canvas& canvas, const std::vector<std::size_t>& faces_of) {
  const std::vector<Canvas::Visible> parts = canvas.visible_parts();
  std::size_t face = 0;
  for (std::size_t block = 0; block < faces_of.size(); ++block) {
    Canvas::Visible all;
    for (const std::size_t end = face + faces_of[block]; face < end; ++face) {
      all.samples += parts[face].samples;
      all.sum = plus(all.sum, parts[face].sum);
    }
    if (all.samples == 0) continue;
    const auto count = static_cast<double>(all.samples);
    const Point middle = times(1 / (count * density), all.sum);
    constexpr int samples_per_length = density * Canvas::samples;  // of a drawing pixel
    draw_number(svg, block, {left_margin + middle[0], top_margin + middle[1]},
                count / (samples_per_length * samples_per_length));
  }
}

/// Draws the directions of the axes in the lower left corner.
void draw_directions(Svg& svg, const Plot& plot) {
  constexpr double length = 34;
  const Point origin{left_margin + 46, plot.bottom() - 40};
  const char* names[] = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Point along{};
    along[axis] = 1;
    along = shown(plot.stage, along);
    const Point tip{origin[0] + length * along[0], origin[1] - length * along[1]};
    svg.line(origin, tip, "stroke=\"#222\" stroke-width=\"1.6\"");
    svg.label({origin[0] + (length + 10) * along[0], origin[1] - (length + 10) * along[1] + 4}, names[axis],
              13, "middle");
  }
}

}  // namespace

void draw_in_space(Svg& svg, const Plot& plot, const Layout& layout, const Frame& start, const Frame& frame) {
  Canvas canvas(static_cast<int>(std::lround(density * plot.width)),
                static_cast<int>(std::lround(density * plot.height)));
  std::vector<std::size_t> faces_of(frame.blocks.size());
  for (std::size_t i = 0; i < frame.blocks.size(); ++i) {
    const BlockFrame& block = frame.blocks[i];
    if (block.vertices.empty()) continue;  // it has been excavated
    faces_of[i] = draw_block(canvas, plot, layout.blocks[i].faces, block.vertices,
                             colour_of(plot.stage, start.blocks[i], block));
  }
  const double line = outline_width(plot, frame) * density * Canvas::samples;
  const Image image = canvas.image(std::max(1, static_cast<int>(std::lround(line))));
  svg.image(plot.corner(), plot.width, plot.height, viewer::base64(png(image)));
  if (plot.stage.numbers) draw_numbers(svg, canvas, faces_of);
  svg.rectangle(plot.corner(), plot.width, plot.height, "fill=\"none\" stroke=\"#222\"");
  draw_directions(svg, plot);
}

}  // namespace halfspace::cli
