#include <span>

#include "geometry/orientation.h"
#include "geometry/polygon/boundary.h"
#include "geometry/polygon/check.h"
#include "geometry/polygon/clean.h"
#include "geometry/polygon/hull.h"
#include "guard.h"
#include "make_polygon.h"
#include "require.h"
#include "shape_faults.h"
#include "shape_handle.h"
#include "strided_view.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {
namespace {

using Points = Array<Vector<2>>;

/// Reads a point that must differ from `end`, whose name is `name_of_end`.
Vector<2> read_other_end(const double point[3], const char* name, const Vector<2>& end,
                         const char* name_of_end) {
  const Vector<2> other = read_finite_vector<2>(point, name);
  if (other == end) {
    refuse(HS_ERROR_ARGUMENT, "%s is %s; it must differ from %s", name, PointText(other).characters,
           name_of_end);
  }
  return other;
}

/// Reads the other end of the neighbour at `joint` of a segment that starts at `from`. NULL is a collinear
/// neighbour.
Vector<2> read_neighbour(const double point[3], const char* name, const Vector<2>& from,
                         const Vector<2>& joint, const char* name_of_joint) {
  if (!point) return 2 * joint - from;
  const Vector<2> other = read_other_end(point, name, joint, name_of_joint);
  if (turn(from, joint, other) == Turn::straight && (joint - from).dot(other - joint) < 0) {
    refuse(HS_ERROR_ARGUMENT, "%s is %s; the chain must not reverse its direction at %s", name,
           PointText(other).characters, name_of_joint);
  }
  return other;
}

}  // namespace

hs_shape* make_polygon(hs_context* context, const Points& vertices, const char* name) {
  const FaultReport report = check_polygon(vertices);
  if (report.fault != Fault::none) refuse_polygon(report, name, vertices);
  return create<ShapeHandle<2>>(context, context, std::span(vertices));
}

}  // namespace halfspace::capi

hs_status hs_polygon_check(hs_context* context, hs_view vertices, hs_fault* fault) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require_pointer(fault, "fault");
    const Points points = read_points<2>(context, vertices, "vertices");
    const FaultReport report = check_polygon(points);
    *fault = {std::int32_t(report.fault), 0, report.vertex, -1};
    return HS_OK;
  });
}

hs_status hs_polygon_create(hs_context* context, hs_view vertices, hs_shape** shape) {
  return make_shape(context, shape, __func__, [&]() -> hs_shape* {
    return make_polygon(context, read_points<2>(context, vertices, "vertices"), "vertices");
  });
}

hs_status hs_polygon_create_hull(hs_context* context, hs_view points, hs_shape** shape) {
  return make_shape(context, shape, __func__, [&]() -> hs_shape* {
    const Points given = read_finite_points<2>(context, points, "points");
    const Points hull = convex_hull(given, &context->memory);
    if (hull.size() < 3) refuse_polygon({Fault::zero_area, -1}, "points", given);
    return make_polygon(context, hull, "hull of points");
  });
}

hs_status hs_polygon_create_boundary(hs_context* context, const double before[3], const double first[3],
                                     const double second[3], const double after[3], double depth,
                                     hs_shape** shape) {
  return make_shape(context, shape, __func__, [&]() -> hs_shape* {
    const Vector<2> start = read_finite_vector<2>(first, "first"),
                    end = read_other_end(second, "second", start, "first");
    const BoundarySegment segment{read_neighbour(before, "before", end, start, "first"), start, end,
                                  read_neighbour(after, "after", start, end, "second")};
    require(depth > 0 && is_within_limits(depth), depth, "depth", "> 0 and at most 1e75");
    const Points vertices = polygon_behind(segment, depth, &context->memory);
    const FaultReport report = vertices.empty() ? FaultReport{Fault::zero_area} : check_polygon(vertices);
    if (report.fault != Fault::none) {
      refuse(HS_ERROR_GEOMETRY, "depth is %g; the polygon behind first %s and second %s %s", depth,
             PointText(start).characters, PointText(end).characters, fault_text(report.fault));
    }
    return create<ShapeHandle<2>>(context, context, std::span(vertices));
  });
}

hs_status hs_polygon_clean(hs_context* context, hs_view vertices, double tolerance, hs_mutable_view cleaned,
                           int64_t* count, hs_clean_report* report) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require_pointer(count, "count");
    require(tolerance >= 0 && std::isfinite(tolerance), tolerance, "tolerance", "finite and >= 0");
    require_view(cleaned, "cleaned");
    CleanReport changes;
    const Points given = read_finite_points<2>(context, vertices, "vertices");
    const Points kept = clean_polygon(given, tolerance, changes, &context->memory);
    *count = std::int64_t(kept.size());
    if (report) *report = {changes.welded, changes.straightened, changes.reversed, 0};
    return write_all(*count, cleaned.count, [&](int i) { write_point(cleaned, i, kept[std::size_t(i)]); });
  });
}
