#pragma once

#include <cstdint>
#include <span>

#include "geometry/fault.h"
#include "geometry/vector.h"

namespace halfspace {

/// The first fault and the vertex it sits at, -1 when it is the whole polygon.
struct FaultReport {
  Fault fault = Fault::none;
  std::int64_t vertex = -1;
};

/// Says what keeps these vertices, in either order, from being a strictly convex polygon.
FaultReport check_polygon(std::span<const Vector<2>> vertices);

/// True when the vertices run clockwise.
bool is_clockwise(std::span<const Vector<2>> vertices);

}  // namespace halfspace
