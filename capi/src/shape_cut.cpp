#include "geometry/polygon/cut.h"
#include "geometry/polyhedron/cut.h"
#include "guard.h"
#include "make_polygon.h"
#include "require.h"
#include "shape_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

/// A plane, in 2D a line, through a point.
template <int D>
struct Plane {
  Vector<D> point;
  Vector<D> normal;
};

template <int D>
Plane<D> read_plane(const double* point, const double* normal) {
  Plane<D> plane;
  for (int i = 0; i < D; ++i) {
    plane.point[i] = require_finite(point[i], "point");
    plane.normal[i] = require_finite(normal[i], "normal");
  }
  if (plane.normal.isZero(0)) {
    refuse(HS_ERROR_ARGUMENT, "normal is %s; it must not be 0", PointText(plane.normal).characters);
  }
  return plane;
}

struct Parts {
  hs_shape* behind = nullptr;
  hs_shape* ahead = nullptr;
};

/// Makes both parts, or none if the second one fails.
template <class Part, class Make>
Parts make_parts(const Part& behind, const Part& ahead, Make make) {
  Parts parts;
  parts.behind = make(behind, "part behind");
  try {
    parts.ahead = make(ahead, "part ahead");
  } catch (...) {
    hs_shape_destroy(parts.behind);
    throw;
  }
  return parts;
}

Parts cut(const Shape<2>& whole, const Plane<2>& line, hs_context* context) {
  const Outline<2>& outline = whole.outline();
  Array<Vector<2>> vertices(&context->memory);
  vertices.reserve(std::size_t(outline.count));
  for (int i = 0; i < outline.count; ++i) vertices.push_back(outline.vertex(i) + whole.centroid());
  const PolygonParts parts = cut_polygon(vertices, line.point, line.normal, &context->memory);
  if (!parts.is_cut()) {
    hs_shape* const copy = create<ShapeHandle<2>>(context, context, whole);
    return parts.is_rather_ahead ? Parts{nullptr, copy} : Parts{copy, nullptr};
  }
  return make_parts(parts.behind, parts.ahead, [&](const Array<Vector<2>>& part, const char* name) {
    return make_polygon(context, part, name);
  });
}

Parts cut(const Shape<3>& whole, const Plane<3>& plane, hs_context* context) {
  Memory* const memory = &context->memory;
  const PolyhedronParts parts =
      cut_polyhedron(polyhedron_of(whole, memory), plane.point, plane.normal, memory);
  return make_parts(parts.behind, parts.ahead, [&](const Polyhedron& part, const char*) -> hs_shape* {
    return part.is_empty() ? nullptr : create<ShapeHandle<3>>(context, context, part);
  });
}

}  // namespace

hs_status hs_shape_cut(const hs_shape* shape, const double point[3], const double normal[3],
                       hs_shape** behind, hs_shape** ahead) {
  return with_shape(shape, __func__, [&]<int D>(const Shape<D>& whole) {
    require_pointer(point, "point");
    require_pointer(normal, "normal");
    require_pointer(behind, "behind");
    require_pointer(ahead, "ahead");
    const Parts parts = cut(whole, read_plane<D>(point, normal), shape->context);
    *behind = parts.behind;
    *ahead = parts.ahead;
    return HS_OK;
  });
}
