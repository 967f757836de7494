#include "shape.h"

#include <span>

#include "check.h"
#include "geometry/polygon_check.h"
#include "geometry/polygon_clean.h"
#include "geometry/polygon_cut.h"
#include "geometry/polygon_hull.h"
#include "guard.h"
#include "view.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

using Points = Array<Vector<2>>;

Points read_points(hs_context* context, const hs_view& view, const char* name) {
  require_view(view, name);
  Points points(&context->memory);
  points.reserve(std::size_t(view.count));
  for (std::int64_t i = 0; i < view.count; ++i) points.push_back(read_point(view, i));
  return points;
}

Points read_finite_points(hs_context* context, const hs_view& view, const char* name) {
  require_view(view, name);
  Points points(&context->memory);
  points.reserve(std::size_t(view.count));
  for (std::int64_t i = 0; i < view.count; ++i) points.push_back(read_finite_point(view, i, name));
  return points;
}

[[noreturn]] void refuse_polygon(const FaultReport& report, const char* name, const Points& points) {
  if (report.vertex < 0) {
    refuse(HS_ERROR_GEOMETRY, "%s (%zu points) %s", name, points.size(), fault_text(report.fault));
  }
  const Vector<2>& p = points[std::size_t(report.vertex)];
  refuse(HS_ERROR_GEOMETRY, "%s[%lld] = (%.17g, %.17g) %s", name, static_cast<long long>(report.vertex),
         p.x(), p.y(), fault_text(report.fault));
}

hs_shape* make_shape(hs_context* context, const Points& points, const char* name) {
  const FaultReport report = check_polygon(points);
  if (report.fault != Fault::none) refuse_polygon(report, name, points);
  return create<hs_shape>(context, context, std::span(points));
}

/// Vertices in the coordinates that the shape was made from.
Points vertices_of(const hs_shape& s) {
  const Outline<2> outline = s.shape.outline();
  Points points(&s.context->memory);
  points.reserve(std::size_t(outline.count));
  for (int i = 0; i < outline.count; ++i) points.push_back(outline.vertex(i) + s.shape.centroid());
  return points;
}

}  // namespace

hs_status hs_polygon_check(hs_context* context, hs_view vertices, hs_fault* fault) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require_pointer(fault, "fault");
    const Points points = read_points(context, vertices, "vertices");
    const FaultReport report = check_polygon(points);
    *fault = {std::int32_t(report.fault), 0, report.vertex};
    return HS_OK;
  });
}

hs_status hs_polygon_create(hs_context* context, hs_view vertices, hs_shape** shape) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require_pointer(shape, "shape");
    *shape = make_shape(context, read_points(context, vertices, "vertices"), "vertices");
    return HS_OK;
  });
}

hs_status hs_polygon_create_hull(hs_context* context, hs_view points, hs_shape** shape) {
  return guarded(context, __func__, [&] {
    require_pointer(context, "context");
    require_pointer(shape, "shape");
    const Points given = read_finite_points(context, points, "points");
    const Points hull = convex_hull(given, &context->memory);
    if (hull.size() < 3) refuse_polygon({Fault::zero_area, -1}, "points", given);
    *shape = make_shape(context, hull, "hull of points");
    return HS_OK;
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
    const Points given = read_finite_points(context, vertices, "vertices");
    const Points kept = clean_polygon(given, tolerance, changes, &context->memory);
    *count = std::int64_t(kept.size());
    const std::int64_t written = std::min(*count, cleaned.count);
    for (std::int64_t i = 0; i < written; ++i) write_point(cleaned, i, kept[std::size_t(i)]);
    if (report) *report = {changes.welded, changes.straightened, changes.reversed, 0};
    return fits(*count, cleaned.count);
  });
}

hs_status hs_shape_cut(const hs_shape* shape, const double point[3], const double normal[3],
                       hs_shape** behind, hs_shape** ahead) {
  hs_context* context = shape ? shape->context : nullptr;
  return guarded(context, __func__, [&] {
    require_pointer(shape, "shape");
    require_pointer(point, "point");
    require_pointer(normal, "normal");
    require_pointer(behind, "behind");
    require_pointer(ahead, "ahead");
    for (int i = 0; i < 2; ++i) {
      require_finite(point[i], "point");
      require_finite(normal[i], "normal");
    }
    if (normal[0] == 0 && normal[1] == 0)
      refuse(HS_ERROR_ARGUMENT, "normal is (0, 0); it must have a direction");
    const PolygonParts parts =
        cut_polygon(vertices_of(*shape), {point[0], point[1]}, {normal[0], normal[1]}, &context->memory);
    const auto part = [&](const Points& vertices, const char* name) {
      return vertices.empty() ? nullptr : make_shape(context, vertices, name);
    };
    hs_shape* first = part(parts.behind, "part behind");
    hs_shape* second = nullptr;
    try {
      second = part(parts.ahead, "part ahead");
    } catch (...) {
      hs_shape_destroy(first);
      throw;
    }
    *behind = first;
    *ahead = second;
    return HS_OK;
  });
}

hs_status hs_shape_get_properties(const hs_shape* shape, hs_shape_properties* properties) {
  return guarded(shape ? shape->context : nullptr, __func__, [&] {
    require_pointer(shape, "shape");
    require_pointer(properties, "properties");
    const Shape<2>& s = shape->shape;
    hs_shape_properties p{};
    p.dimension = 2;
    p.vertex_count = s.vertex_count();
    p.face_count = s.vertex_count();
    p.volume = s.area();
    write_vector(s.centroid(), p.centroid);
    p.second_moment[0] = s.second_moment()[0];
    p.second_moment[1] = s.second_moment()[1];
    p.second_moment[3] = s.second_moment()[2];
    p.bounding_radius = s.bounding_radius();
    p.shortest_edge = s.shortest_edge();
    *properties = p;
    return HS_OK;
  });
}

hs_status hs_shape_get_vertices(const hs_shape* shape, hs_mutable_view vertices, int64_t* count) {
  return guarded(shape ? shape->context : nullptr, __func__, [&] {
    require_pointer(shape, "shape");
    require_view(vertices, "vertices");
    const Outline<2> outline = shape->shape.outline();
    const std::int64_t written = std::min<std::int64_t>(outline.count, vertices.count);
    for (std::int64_t i = 0; i < written; ++i) {
      write_point(vertices, i, outline.vertex(int(i)) + shape->shape.centroid());
    }
    if (count) *count = outline.count;
    return fits(outline.count, vertices.count);
  });
}

hs_status hs_shape_get_halfspaces(const hs_shape* shape, hs_mutable_view normals, double* offsets,
                                  int64_t* count) {
  return guarded(shape ? shape->context : nullptr, __func__, [&] {
    require_pointer(shape, "shape");
    require_view(normals, "normals");
    const Outline<2> outline = shape->shape.outline();
    const std::int64_t written = std::min<std::int64_t>(outline.count, normals.count);
    for (std::int64_t i = 0; i < written; ++i) {
      write_point(normals, i, outline.normal(int(i)));
      if (offsets) offsets[i] = outline.offset[i];
    }
    if (count) *count = outline.count;
    return fits(outline.count, normals.count);
  });
}

void hs_shape_destroy(hs_shape* shape) {
  if (shape) destroy(shape->context, shape);
}
