#pragma once

#include <cstdint>
#include <string>

namespace halfspace::cli {

struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};

/// The colour scale from 0 (blue) to 1 (yellow), of increasing lightness: readable in grey and with colour
/// blindness.
Rgb ramp_colour(double position);

/// The colour scaled by a brightness.
Rgb lit(Rgb colour, double light);

/// As SVG writes it, e.g. "#1b1b1b".
std::string hex(Rgb colour);

}  // namespace halfspace::cli
