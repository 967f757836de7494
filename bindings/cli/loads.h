#pragma once

#include <vector>

#include "model.h"

namespace halfspace::cli {

/// The weight that each block bears once all lies still: its own and its part of what is above it, as that
/// presses straight down. Of blocks that do not move freely it is 0.
std::vector<double> loads_of(const Frame& frame, const Point& gravity);

}  // namespace halfspace::cli
