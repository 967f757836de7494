#include "geometry/polyhedron/polyhedron.h"

#include <limits>

#include "geometry/polyhedron/check.h"
#include "geometry/polyhedron/fit_polyhedron.h"
#include "geometry/polyhedron/halfspaces.h"
#include "geometry/polyhedron/hull.h"
#include "guard.h"
#include "require.h"
#include "shape_faults.h"
#include "shape_handle.h"
#include "strided_view.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

/// Vertices, edges and faces have 32-bit indices, also during construction: a hull has up to six facet
/// corners per point.
constexpr int bits_of_points = 26;

/// Reads vertices and faces; refuses invalid counts.
Polyhedron read_polyhedron(hs_context* context, const hs_view& vertices, const std::int32_t* face_sizes,
                           std::int64_t face_count, const std::int32_t* face_vertices) {
  require_numbered(vertices.count, "vertices.count", bits_of_points);
  require_numbered(face_count, "face_count", bits_of_points);
  if (face_count > 0) require_pointer(face_sizes, "face_sizes");
  std::int64_t total = 0;
  for (std::int64_t f = 0; f < face_count; ++f) {
    if (face_sizes[f] < 0) {
      refuse(HS_ERROR_ARGUMENT, "face_sizes[%lld] is %d; it must be >= 0", static_cast<long long>(f),
             face_sizes[f]);
    }
    total += face_sizes[f];
  }
  require_numbered(total, "the sum of face_sizes", bits_of_points);
  if (total > 0) require_pointer(face_vertices, "face_vertices");

  Polyhedron polyhedron(&context->memory);
  polyhedron.vertices = read_points<3>(context, vertices, "vertices");
  polyhedron.face_vertices.assign(face_vertices, face_vertices + total);
  polyhedron.first_of_face.reserve(std::size_t(face_count) + 1);
  for (std::int64_t f = 0; f < face_count; ++f)
    polyhedron.first_of_face.push_back(polyhedron.first_of_face.back() + face_sizes[f]);
  return polyhedron;
}

/// Only points out of range are faulty individually; other faults concern all points.
[[noreturn]] void refuse_hull(const PolyhedronFault& report, const Array<Vector<3>>& points) {
  const bool is_one = report.fault == Fault::out_of_range;
  refuse_points<3>(points, is_one ? report.vertex : -1, "points", "hull of points", fault_text(report.fault));
}

hs_fit_report to_report(const FitReport& fit) {
  const PolyhedronFault& fault = fit.fault;
  return {{std::int32_t(fault.fault), 0, fault.vertex, fault.face},
          fit.merged,
          fit.deviation,
          fit.moved,
          fit.sufficient};
}

[[noreturn]] void refuse_fit(const FitReport& report, double tolerance, const Array<Vector<3>>& vertices) {
  if (report.fault.fault != Fault::beyond_tolerance) refuse_polyhedron(report.fault, vertices);
  char remedy[48] = "no tolerance below its size is sufficient";
  if (report.sufficient > 0)
    std::snprintf(remedy, sizeof remedy, "a tolerance of %.2g is sufficient", report.sufficient);
  refuse(HS_ERROR_GEOMETRY, "face %lld has a dent %.3g deep at vertices[%lld] = %s; tolerance is %g, %s",
         static_cast<long long>(report.fault.face), report.deviation,
         static_cast<long long>(report.fault.vertex),
         PointText(vertices[std::size_t(report.fault.vertex)]).characters, tolerance, remedy);
}

[[noreturn]] void refuse_halfspaces(const PolyhedronFault& report, const Array<Halfspace<3>>& halfspaces) {
  const char* const text = fault_text(report.fault);
  const bool is_one = report.fault == Fault::out_of_range || report.fault == Fault::no_direction;
  if (!is_one || report.face < 0)
    refuse(HS_ERROR_GEOMETRY, "normals and offsets (%zu half-spaces) %s", halfspaces.size(), text);
  const Halfspace<3>& faulty = halfspaces[std::size_t(report.face)];
  refuse(HS_ERROR_GEOMETRY, "half-space %lld, normal %s and offset %.17g, %s",
         static_cast<long long>(report.face), PointText(faulty.normal).characters, faulty.offset, text);
}

}  // namespace

hs_status hs_polyhedron_check(hs_context* context, hs_view vertices, const int32_t face_sizes[],
                              int64_t face_count, const int32_t face_vertices[], hs_fault* fault) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require_pointer(fault, "fault");
    Polyhedron polyhedron = read_polyhedron(context, vertices, face_sizes, face_count, face_vertices);
    const PolyhedronFault report = complete_polyhedron(polyhedron);
    *fault = {std::int32_t(report.fault), 0, report.vertex, report.face};
    return HS_OK;
  });
}

hs_status hs_polyhedron_create(hs_context* context, hs_view vertices, const int32_t face_sizes[],
                               int64_t face_count, const int32_t face_vertices[], hs_shape** shape) {
  return make_shape(context, shape, __func__, [&]() -> hs_shape* {
    Polyhedron polyhedron = read_polyhedron(context, vertices, face_sizes, face_count, face_vertices);
    const PolyhedronFault report = complete_polyhedron(polyhedron);
    if (report.fault != Fault::none) refuse_polyhedron(report, polyhedron.vertices);
    return create<ShapeHandle<3>>(context, context, polyhedron);
  });
}

hs_status hs_polyhedron_create_hull(hs_context* context, hs_view points, hs_shape** shape) {
  return make_shape(context, shape, __func__, [&]() -> hs_shape* {
    require_numbered(points.count, "points.count", bits_of_points);
    const Array<Vector<3>> given = read_finite_points<3>(context, points, "points");
    Polyhedron hull(&context->memory);
    const PolyhedronFault report = convex_hull(given, hull);
    if (report.fault != Fault::none) refuse_hull(report, given);
    return create<ShapeHandle<3>>(context, context, hull);
  });
}

hs_status hs_polyhedron_create_fitted(hs_context* context, hs_view vertices, const int32_t face_sizes[],
                                      int64_t face_count, const int32_t face_vertices[], double tolerance,
                                      hs_shape** shape, hs_fit_report* report) {
  return make_shape(context, shape, __func__, [&]() -> hs_shape* {
    require(tolerance >= 0 && std::isfinite(tolerance), tolerance, "tolerance", "finite and >= 0");
    Polyhedron polyhedron = read_polyhedron(context, vertices, face_sizes, face_count, face_vertices);
    const Array<Vector<3>> given(polyhedron.vertices, &context->memory);
    const FitReport fit = fit_polyhedron(polyhedron, tolerance);
    const bool is_fitted = fit.fault.fault == Fault::none;
    hs_shape* const made = is_fitted ? create<ShapeHandle<3>>(context, context, polyhedron) : nullptr;
    if (report) *report = to_report(fit);
    if (!made) refuse_fit(fit, tolerance, given);
    return made;
  });
}

hs_status hs_polyhedron_create_from_halfspaces(hs_context* context, hs_view normals, const double offsets[],
                                               hs_shape** shape) {
  return make_shape(context, shape, __func__, [&]() -> hs_shape* {
    require_numbered(normals.count, "normals.count", bits_of_points);
    require_view<3>(normals, "normals");
    if (normals.count > 0) require_pointer(offsets, "offsets");
    Array<Halfspace<3>> halfspaces(&context->memory);
    halfspaces.reserve(std::size_t(normals.count));
    for (std::int64_t i = 0; i < normals.count; ++i)
      halfspaces.push_back({read_point<3>(normals, i), offsets[i]});

    Polyhedron polyhedron(&context->memory);
    std::int64_t redundant = 0;  // the number of faces shows it
    const PolyhedronFault report = polyhedron_from_halfspaces(halfspaces, polyhedron, redundant);
    if (report.fault != Fault::none) refuse_halfspaces(report, halfspaces);
    return create<ShapeHandle<3>>(context, context, polyhedron);
  });
}
