#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "common/vector.h"

namespace halfspace::cli {

/// The sine of an angle below which two directions are one; times the size of an outline, the distance below
/// which two places are one.
inline constexpr double straight = 1e-9;

/// A place where an outline touches or crosses itself.
struct SelfContact {
  std::size_t
      vertex;  ///< at which the outline touches itself, or from which an edge goes that crosses another
  std::string text;
};

/// The first place where an outline touches or crosses itself: a corner on another corner or on an edge, two
/// edges that cross, or a spike, at which the outline turns back. Quadratic in the number of vertices.
std::optional<SelfContact> find_self_contact(const std::vector<Point>& vertices);

}  // namespace halfspace::cli
