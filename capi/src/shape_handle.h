#pragma once

#include "context_handle.h"
#include "geometry/shape.h"
#include "guard.h"
#include "halfspace/shape.h"
#include "require.h"

/// Members of handles of both dimensions. ShapeHandle adds the shape.
struct hs_shape {
  int dimension() const { return polygon_vertices < no_polygon ? 2 : 3; }

  /// Above any limit on polygon vertices, so that a comparison with the limit also excludes polyhedra.
  static constexpr std::int32_t no_polygon = INT32_MAX;

  hs_context* context;
  std::int32_t polygon_vertices;
};

namespace halfspace::capi {

/// Handle with its shape.
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

/// Calls use(shape) with the Shape<2> or Shape<3> of the handle.
template <class Use>
auto visit(const hs_shape& handle, Use&& use) {
  return handle.dimension() == 2 ? use(as<2>(handle)) : use(as<3>(handle));
}

template <class Use>
auto visit(hs_shape& handle, Use&& use) {
  return handle.dimension() == 2 ? use(static_cast<ShapeHandle<2>&>(handle).shape)
                                 : use(static_cast<ShapeHandle<3>&>(handle).shape);
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

/// The body of an entry point: guarded, calls use(shape) with the Shape<2> or Shape<3> of the handle.
template <class Use>
hs_status with_shape(const hs_shape* shape, const char* function, Use&& use) {
  return guarded(context_of(shape), function, [&] {
    require_pointer(shape, "shape");
    return visit(*shape, use);
  });
}

}  // namespace halfspace::capi
