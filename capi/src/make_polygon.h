#pragma once

#include "geometry/vector.h"
#include "halfspace/shape.h"

namespace halfspace::capi {

/// A shape from vertices in either order; refuses faulty ones. `name` says in the text what they are.
hs_shape* make_polygon(hs_context* context, const Array<Vector<2>>& vertices, const char* name);

}  // namespace halfspace::capi
