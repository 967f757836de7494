#pragma once

#include <vector>

#include "model/model.h"

namespace halfspace::cli {

/// The vertical load of each block at rest: its own weight, and its part of the weight above it. 0 for blocks
/// that do not move freely.
std::vector<double> loads_of(const Frame& frame, const Point& gravity);

}  // namespace halfspace::cli
