#pragma once

#include <cstdint>
#include <span>

#include "geometry/vector.h"

namespace halfspace {

/// What can be wrong with a polygon's vertices. The values are those of the C API.
enum class Fault : std::int32_t {
  none = 0,
  too_few_vertices = 1,
  not_finite = 2,
  repeated_vertex = 3,
  collinear_vertex = 4,
  not_convex = 5,
  self_crossing = 6,
  zero_area = 7,
};

/// The first fault and the vertex it sits at, -1 when it is the whole polygon.
struct FaultReport {
  Fault fault = Fault::none;
  std::int64_t vertex = -1;
};

/// The fault in words, e.g. "is on the line of its neighbours".
const char* fault_text(Fault fault);

/// Says what keeps these vertices, in either order, from being a strictly convex polygon.
FaultReport check_polygon(std::span<const Vector<2>> vertices);

/// True when the vertices run clockwise.
bool is_clockwise(std::span<const Vector<2>> vertices);

}  // namespace halfspace
