#include "output/picture/colour.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace halfspace::cli {
namespace {

std::uint8_t level(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

}  // namespace

Rgb ramp_colour(double position) {
  static constexpr double stops[][3] = {
      {72, 92, 158}, {52, 138, 178}, {72, 180, 150}, {160, 210, 110}, {252, 226, 100}};
  constexpr int last = 4;
  const double segment = last * std::clamp(position, 0.0, 1.0);
  const int below = std::min(static_cast<int>(segment), last - 1);
  const double part = segment - below;
  const auto mixed = [&](int i) { return level((1 - part) * stops[below][i] + part * stops[below + 1][i]); };
  return {mixed(0), mixed(1), mixed(2)};
}

Rgb lit(Rgb colour, double light) {
  return {level(light * colour.red), level(light * colour.green), level(light * colour.blue)};
}

std::string hex(Rgb colour) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", colour.red, colour.green, colour.blue);
  return text;
}

}  // namespace halfspace::cli
