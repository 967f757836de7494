#pragma once

#include "context_handle.h"
#include "geometry/shape.h"
#include "guard.h"
#include "halfspace/shape.h"
#include "require.h"

/// The part that shapes of either dimension have. The shape itself follows, see ShapeHandle.
struct hs_shape {
  int dimension() const { return polygon_vertices < no_polygon ? 2 : 3; }

  /// Beyond any limit to the vertices of polygons, so that a comparison with one tells polyhedra as well.
  static constexpr std::int32_t no_polygon = INT32_MAX;

  hs_context* context;
  std::int32_t polygon_vertices;
};

namespace halfspace::capi {

/// A shape behind its handle.
template <int D>
struct ShapeHandle : hs_shape {
  template <class Source>
  ShapeHandle(hs_context* owner, const Source& source)
      : hs_shape{owner, no_polygon}, shape(source, &owner->memory) {
    if (D == 2) polygon_vertices = shape.vertex_count();
  }

  Shape<D> shape;
};

inline hs_context* context_of(const hs_shape* shape) { return shape ? shape->context : nullptr; }

/// The handle has dimension D.
template <int D>
const Shape<D>& as(const hs_shape& handle) {
  return static_cast<const ShapeHandle<D>&>(handle).shape;
}

/// Calls use(shape) with the Shape<2> or Shape<3> that the handle is.
template <class Use>
auto visit(const hs_shape& handle, Use&& use) {
  return handle.dimension() == 2 ? use(as<2>(handle)) : use(as<3>(handle));
}

/// The body of an entry point that makes a shape.
template <class Make>
hs_status make_shape(hs_context* context, hs_shape** shape, const char* function, Make&& make) {
  return guarded(context, function, [&] {
    require_pointer(context, "context");
    require_pointer(shape, "shape");
    *shape = make();
    return HS_OK;
  });
}

/// The body of an entry point: guarded, with the shape as what it is.
template <class Use>
hs_status with_shape(const hs_shape* shape, const char* function, Use&& use) {
  return guarded(context_of(shape), function, [&] {
    require_pointer(shape, "shape");
    return visit(*shape, use);
  });
}

}  // namespace halfspace::capi
