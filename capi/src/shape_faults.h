#pragma once

#include "geometry/polygon/check.h"
#include "geometry/polyhedron/check.h"

namespace halfspace::capi {

/// Refuses the vertices of a polygon; `name` is their name in the error text.
[[noreturn]] void refuse_polygon(const FaultReport& report, const char* name,
                                 const Array<Vector<2>>& vertices);

/// Refuses a polyhedron. The text names the faulty face and vertex.
[[noreturn]] void refuse_polyhedron(const PolyhedronFault& report, const Array<Vector<3>>& vertices);

}  // namespace halfspace::capi
