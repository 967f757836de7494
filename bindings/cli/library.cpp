#include "library.h"

namespace halfspace::cli {

void require(const Context& context, hs_status status) {
  if (status >= 0) return;
  const std::string text = hs_context_last_error(context.get());
  throw LibraryError(status, text.empty() ? hs_status_string(status) : text);
}

Context make_context() {
  hs_context* context = nullptr;
  const hs_status status = hs_context_create(nullptr, &context);
  if (status < 0) throw LibraryError(status, hs_status_string(status));
  return Context(context);
}

hs_view view_of(const std::vector<Point>& points) {
  if (points.empty()) return {};
  return {points[0].data(), points[0].data() + 1, nullptr, sizeof(Point),
          static_cast<int64_t>(points.size())};
}

hs_mutable_view view_of(std::vector<Point>& points) {
  if (points.empty()) return {};
  return {points[0].data(), points[0].data() + 1, nullptr, sizeof(Point),
          static_cast<int64_t>(points.size())};
}

Shape make_polygon(const Context& context, const std::vector<Point>& vertices) {
  hs_shape* shape = nullptr;
  require(context, hs_polygon_create(context.get(), view_of(vertices), &shape));
  return Shape(shape);
}

hs_shape_properties properties_of(const Context& context, const Shape& shape) {
  hs_shape_properties properties;
  require(context, hs_shape_get_properties(shape.get(), &properties));
  return properties;
}

std::vector<Point> vertices_of(const Context& context, const Shape& shape) {
  std::vector<Point> vertices(static_cast<std::size_t>(properties_of(context, shape).vertex_count));
  require(context, hs_shape_get_vertices(shape.get(), view_of(vertices), nullptr));
  return vertices;
}

}  // namespace halfspace::cli
