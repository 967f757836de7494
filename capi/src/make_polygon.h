#pragma once

#include "geometry/vector.h"
#include "halfspace/shape.h"

namespace halfspace::capi {

/// Creates a shape from vertices in either order; refuses faulty vertices. `name` is their name in the error
/// text.
hs_shape* make_polygon(hs_context* context, const Array<Vector<2>>& vertices, const char* name);

}  // namespace halfspace::capi
