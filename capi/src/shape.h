#pragma once

#include "context.h"
#include "fingerprint.h"
#include "geometry/shape.h"
#include "guard.h"
#include "halfspace/shape.h"

/// What shapes of either dimension have. The shape itself follows, see ShapeHandle.
struct hs_shape {
  int dimension() const { return polygon_vertices < no_polygon ? 2 : 3; }

  /// Beyond any limit to the vertices of polygons, so that a comparison with one tells polyhedra as well.
  static constexpr std::int32_t no_polygon = INT32_MAX;

  hs_context* context;
  std::uint64_t fingerprint;
  std::int32_t polygon_vertices;
};

namespace halfspace::capi {

/// A shape behind its handle.
template <int D>
struct ShapeHandle : hs_shape {
  template <class Source>
  ShapeHandle(hs_context* owner, const Source& source)
      : hs_shape{owner, 0, no_polygon}, shape(source, &owner->memory) {
    fingerprint = fingerprint_of(shape.outline());
    if (D == 2) polygon_vertices = shape.vertex_count();
  }

  Shape<D> shape;
};

/// Of a handle whose dimension is D.
template <int D>
const ShapeHandle<D>& as(const hs_shape& handle) {
  return static_cast<const ShapeHandle<D>&>(handle);
}

/// Calls use(handle) with the handle as what it is.
template <class Use>
auto visit(const hs_shape& handle, Use&& use) {
  return handle.dimension() == 2 ? use(as<2>(handle)) : use(as<3>(handle));
}

}  // namespace halfspace::capi
