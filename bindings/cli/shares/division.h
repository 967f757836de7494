#pragma once

#include <cstddef>
#include <vector>

#include "common/vector.h"

namespace halfspace::cli {

/// Divides points into so many parts of equal size, to one point, by recursive bisection across the longest
/// side of their box. @return the indices of each part, in ascending order
std::vector<std::vector<std::size_t>> bisect(const std::vector<Point>& points, std::size_t parts);

}  // namespace halfspace::cli
