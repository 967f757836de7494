#pragma once

#include <cstdint>

#include "geometry/vector.h"

namespace halfspace {

enum class QuickhullResult { ok, flat, failed };

/// Facets of the convex hull of points x y z x y z ..., by the reentrant qhull (Barber, Dobkin and Huhdanpaa
/// 1996). Facets within `coplanar` of one plane are one. A facet's loop of points is
/// corners[first_of_facet[f]] to corners[first_of_facet[f + 1]], the latter excluded; all loops are of one
/// orientation, which is left open. Throws bad_alloc when there is no memory.
QuickhullResult quickhull(Array<double>& coordinates, double coplanar, Array<std::int32_t>& first_of_facet,
                          Array<std::int32_t>& corners);

}  // namespace halfspace
