#pragma once

#include <cstdint>

#include "geometry/vector.h"

namespace halfspace {

enum class QuickhullResult { ok, flat, failed, unavailable };

/// Facets of the convex hull of points x y z x y z ..., by the reentrant qhull (Barber, Dobkin and Huhdanpaa
/// 1996). Facets within `coplanar` of one plane are merged. The loop of facet f is corners[first_of_facet[f]]
/// to corners[first_of_facet[f + 1]], the latter excluded; all loops have one orientation, either one. Throws
/// bad_alloc when memory runs out. Unavailable where neither Qhull nor its sources were found
/// (without_qhull/).
QuickhullResult quickhull(Array<double>& coordinates, double coplanar, Array<std::int32_t>& first_of_facet,
                          Array<std::int32_t>& corners);

}  // namespace halfspace
