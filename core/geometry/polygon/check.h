#pragma once

#include <cstdint>
#include <span>

#include "geometry/fault.h"
#include "geometry/vector.h"

namespace halfspace {

/// The first fault and its vertex, -1 for the whole polygon.
struct FaultReport {
  Fault fault = Fault::none;
  std::int64_t vertex = -1;
};

/// Returns the fault of these vertices, in either order, as a strictly convex polygon.
FaultReport check_polygon(std::span<const Vector<2>> vertices);

bool is_clockwise(std::span<const Vector<2>> vertices);

}  // namespace halfspace
