#pragma once

#include <cstdint>
#include <string>

namespace halfspace::cli {

struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};

/// A colour from 0 (blue) to 1 (yellow), of rising lightness, so that it reads in grey and by colour-blind
/// eyes.
Rgb ramp_colour(double share);

/// The colour with a share of its light.
Rgb lit(Rgb colour, double light);

/// As SVG writes it, e.g. "#1b1b1b".
std::string hex(Rgb colour);

}  // namespace halfspace::cli
