#include "model/library.h"

#include <utility>

#include "common/interrupt.h"

namespace halfspace::cli {

std::string LibraryError::reason() const {
  const std::string text = what();
  const std::size_t colon = text.find(": ");
  return colon == std::string::npos ? text : text.substr(colon + 2);
}

void require(const Context& context, hs_status status) {
  if (status >= 0) return;
  const std::string text = hs_context_last_error(context.get());
  throw LibraryError(status, text.empty() ? hs_status_string(status) : text);
}

Context make_context(int threads) {
  hs_context_def def;
  hs_context_def_init(&def, sizeof def);
  def.threads = threads;
  def.interrupt = [](void*) { return static_cast<int32_t>(interrupt_requested()); };
  hs_context* context = nullptr;
  const hs_status status = hs_context_create(&def, &context);
  if (status < 0) throw LibraryError(status, hs_status_string(status));
  return Context(context);
}

hs_view view_of(const std::vector<Point>& points) {
  if (points.empty()) return {};
  return {points[0].data(), points[0].data() + 1, points[0].data() + 2, sizeof(Point),
          static_cast<int64_t>(points.size())};
}

hs_mutable_view view_of(std::vector<Point>& points) {
  if (points.empty()) return {};
  return {points[0].data(), points[0].data() + 1, points[0].data() + 2, sizeof(Point),
          static_cast<int64_t>(points.size())};
}

Shape make_polygon(const Context& context, const std::vector<Point>& vertices) {
  hs_shape* shape = nullptr;
  require(context, hs_polygon_create(context.get(), view_of(vertices), &shape));
  return Shape(shape);
}

Shape make_boundary(const Context& context, const std::vector<Point>& chain, std::size_t index,
                    double depth) {
  const double* before = index > 0 ? chain[index - 1].data() : nullptr;
  const double* after = index + 2 < chain.size() ? chain[index + 2].data() : nullptr;
  hs_shape* shape = nullptr;
  require(context, hs_polygon_create_boundary(context.get(), before, chain[index].data(),
                                              chain[index + 1].data(), after, depth, &shape));
  return Shape(shape);
}

FaceList::FaceList(const std::vector<std::vector<int>>& loops) {
  for (const std::vector<int>& loop : loops) {
    sizes.push_back(static_cast<int32_t>(loop.size()));
    vertices.insert(vertices.end(), loop.begin(), loop.end());
  }
}

Shape make_polyhedron(const Context& context, const std::vector<Point>& vertices, const FaceList& faces) {
  hs_shape* shape = nullptr;
  require(context, hs_polyhedron_create(context.get(), view_of(vertices), faces.sizes.data(), faces.count(),
                                        faces.vertices.data(), &shape));
  return Shape(shape);
}

Shape make_hull(const Context& context, const std::vector<Point>& points) {
  hs_shape* shape = nullptr;
  require(context, hs_polyhedron_create_hull(context.get(), view_of(points), &shape));
  return Shape(shape);
}

Shape make_from_halfspaces(const Context& context, const std::vector<HalfSpace>& halfspaces) {
  std::vector<Point> normals;
  std::vector<double> offsets;
  for (const HalfSpace& halfspace : halfspaces) {
    normals.push_back(halfspace.normal);
    offsets.push_back(halfspace.offset);
  }
  hs_shape* shape = nullptr;
  require(context, hs_polyhedron_create_from_halfspaces(context.get(), view_of(std::as_const(normals)),
                                                        offsets.data(), &shape));
  return Shape(shape);
}

Shape make_fitted(const Context& context, const std::vector<Point>& vertices, const FaceList& facets,
                  double tolerance, hs_fit_report& report) {
  hs_shape* shape = nullptr;
  require(context,
          hs_polyhedron_create_fitted(context.get(), view_of(vertices), facets.sizes.data(), facets.count(),
                                      facets.vertices.data(), tolerance, &shape, &report));
  return Shape(shape);
}

CutShape cut(const Context& context, const Shape& shape, const Point& point, const Point& normal) {
  hs_shape* behind = nullptr;
  hs_shape* ahead = nullptr;
  require(context, hs_shape_cut(shape.get(), point.data(), normal.data(), &behind, &ahead));
  return {Shape(behind), Shape(ahead)};
}

hs_shape_properties properties_of(const Context& context, const Shape& shape) {
  hs_shape_properties properties;
  require(context, hs_shape_get_properties(shape.get(), &properties, sizeof properties));
  return properties;
}

std::vector<Point> vertices_of(const Context& context, const Shape& shape) {
  std::vector<Point> vertices(static_cast<std::size_t>(properties_of(context, shape).vertex_count));
  require(context, hs_shape_get_vertices(shape.get(), view_of(vertices), nullptr));
  return vertices;
}

std::vector<HalfSpace> halfspaces_of(const Context& context, const Shape& shape) {
  const auto count = static_cast<std::size_t>(properties_of(context, shape).face_count);
  std::vector<Point> normals(count);
  std::vector<double> offsets(count);
  require(context, hs_shape_get_halfspaces(shape.get(), view_of(normals), offsets.data(), nullptr));
  std::vector<HalfSpace> halfspaces;
  for (std::size_t i = 0; i < count; ++i) halfspaces.push_back({normals[i], offsets[i]});
  return halfspaces;
}

std::vector<std::vector<int>> faces_of(const Context& context, const Shape& shape) {
  const hs_shape_properties properties = properties_of(context, shape);
  std::vector<int32_t> first(static_cast<std::size_t>(properties.face_count + 1));
  std::vector<int32_t> vertices(static_cast<std::size_t>(2 * properties.edge_count));
  require(context,
          hs_shape_get_faces(shape.get(), first.data(), static_cast<int64_t>(first.size()), vertices.data(),
                             static_cast<int64_t>(vertices.size()), nullptr, nullptr));
  std::vector<std::vector<int>> faces;
  for (std::size_t i = 0; i + 1 < first.size(); ++i)
    faces.emplace_back(vertices.begin() + first[i], vertices.begin() + first[i + 1]);
  return faces;
}

std::string snapshot_of(const Context& context, const hs_world* world) {
  std::size_t size = 0;
  require(context, hs_world_save(world, nullptr, 0, &size));
  std::string bytes(size, '\0');
  require(context, hs_world_save(world, bytes.data(), size, &size));
  return bytes;
}

World restored(const Context& context, const std::string& snapshot) {
  hs_world* world = nullptr;
  require(context, hs_world_restore(context.get(), snapshot.data(), snapshot.size(), &world));
  return World(world);
}

}  // namespace halfspace::cli
