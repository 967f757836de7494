#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/vector.h"

namespace halfspace::cli {

/// Steps of 1, 2 or 5 times a power of ten, about `count` of them in a length.
double even_step(double length, int count);

/// The multiples of a step from one value to another; empty if rounding makes them equal.
std::vector<double> multiples_of(double step, double low, double high);

/// The decimals that distinguish multiples of a step.
int decimals_for(double step);

/// A multiple of a step on a scale, with its decimals, or with a power of ten.
std::string number_on_scale(double value, double step, double low, double high);

/// A drawing in pixels, y downwards.
class Svg {
 public:
  Svg(double width, double height);

  void rectangle(Point corner, double width, double height, std::string_view style);
  /// A PNG image in base64, stretched over a rectangle.
  void image(Point corner, double width, double height, std::string_view png);
  void line(Point from, Point to, std::string_view style);
  void polygon(const std::vector<Point>& vertices, std::string_view style);
  /// Anchor: start, middle or end.
  void label(Point at, std::string_view text, double size, std::string_view anchor, double rotation = 0);
  /// Clips everything until end_clip() to a rectangle.
  void begin_clip(Point corner, double width, double height);
  void end_clip();

  std::string text() const { return text_ + "</svg>\n"; }

 private:
  std::string text_;
};

}  // namespace halfspace::cli
