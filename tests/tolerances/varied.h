#pragma once

#include <cmath>
#include <cstdlib>
#include <string>

namespace halfspace {

/// The value of a tolerance; where the environment has HALFSPACE_VARY=NAME=FACTOR, that times the factor. Of
/// a value that is nearly 1, the difference from 1 is multiplied.
inline double varied(const std::string& name, double value) {
  const char* variation = std::getenv("HALFSPACE_VARY");
  const std::string text = variation ? variation : "";
  if (!text.starts_with(name + "=")) return value;
  const double origin = value != 1 && std::abs(value - 1) < 0.01 ? 1 : 0;
  return origin + std::stod(text.substr(name.size() + 1)) * (value - origin);
}

}  // namespace halfspace
