#pragma once

#include <cstdint>
#include <span>

#include "geometry/vector.h"

namespace halfspace {

/// The changes that clean_polygon() made.
struct CleanReport {
  std::int64_t welded = 0;
  std::int64_t straightened = 0;
  bool reversed = false;
};

/// Removes vertices within the tolerance of the one before or of the line of their neighbours, and makes the
/// order counter-clockwise. No vertex moves.
Array<Vector<2>> clean_polygon(std::span<const Vector<2>> vertices, double tolerance, CleanReport& report,
                               Memory* memory);

}  // namespace halfspace
