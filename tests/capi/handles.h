#pragma once

// Owners of the C API's handles, and the few conversions that every test needs. No test logic.

#include <halfspace/halfspace.h>

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace halfspace_test {

struct Point {
  double x = 0;
  double y = 0;
};
using Points = std::vector<Point>;

struct Destroy {
  void operator()(hs_context* c) const { hs_context_destroy(c); }
  void operator()(hs_shape* s) const { hs_shape_destroy(s); }
  void operator()(hs_world* w) const { hs_world_destroy(w); }
};
using Context = std::unique_ptr<hs_context, Destroy>;
using Shape = std::unique_ptr<hs_shape, Destroy>;
using World = std::unique_ptr<hs_world, Destroy>;

inline hs_view view_of(const Points& p) {
  if (p.empty()) return {};
  return {&p[0].x, &p[0].y, nullptr, sizeof(Point), std::int64_t(p.size())};
}

inline hs_mutable_view mutable_view_of(Points& p) {
  if (p.empty()) return {};
  return {&p[0].x, &p[0].y, nullptr, sizeof(Point), std::int64_t(p.size())};
}

inline void require_ok(hs_status status, const hs_context* context) {
  if (status != HS_OK)
    throw std::runtime_error(std::string(hs_status_string(status)) + ": " + hs_context_last_error(context));
}

inline hs_context_def with_threads(std::int32_t threads) {
  hs_context_def def;
  if (hs_context_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no defaults");
  def.threads = threads;
  return def;
}

inline Context make_context(const hs_context_def* def = nullptr) {
  hs_context* context = nullptr;
  if (hs_context_create(def, &context) != HS_OK) throw std::runtime_error("no context");
  return Context(context);
}

/// NULL when the library refuses the vertices as faulty.
inline Shape try_shape(hs_context* context, const Points& vertices) {
  hs_shape* shape = nullptr;
  const hs_status status = hs_polygon_create(context, view_of(vertices), &shape);
  if (status != HS_ERROR_GEOMETRY) require_ok(status, context);
  return Shape(shape);
}

inline Shape make_shape(hs_context* context, const Points& vertices) {
  hs_shape* shape = nullptr;
  require_ok(hs_polygon_create(context, view_of(vertices), &shape), context);
  return Shape(shape);
}

inline hs_shape_properties properties_of(const hs_shape* shape) {
  hs_shape_properties properties{};
  if (hs_shape_get_properties(shape, &properties, sizeof properties) != HS_OK)
    throw std::runtime_error("no properties");
  return properties;
}

inline Points vertices_of(const hs_shape* shape) {
  Points vertices(std::size_t(properties_of(shape).vertex_count));
  if (hs_shape_get_vertices(shape, mutable_view_of(vertices), nullptr) != HS_OK)
    throw std::runtime_error("no vertices");
  return vertices;
}

inline Points box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// The pair of a contact in 2D: whose edge, 0 block a, 1 block b; which; and the other's vertex.
struct EdgeAndVertex {
  int owner, edge, vertex;
};

inline EdgeAndVertex edge_and_vertex(const hs_contact& c) {
  return c.pair_kind == HS_PAIR_FACE_VERTEX ? EdgeAndVertex{0, c.feature_a, c.feature_b}
                                            : EdgeAndVertex{1, c.feature_b, c.feature_a};
}

inline hs_pair_cache cache_of(std::int32_t state, std::int32_t kind, std::int32_t feature_a,
                              std::int32_t feature_b) {
  hs_pair_cache cache{};
  cache.state = state;
  cache.pair_kind = kind;
  cache.feature_a = feature_a;
  cache.feature_b = feature_b;
  return cache;
}

/// In 2D, along the tangent (-n.y, n.x).
inline double shear_along_tangent(const hs_contact& c) {
  return c.normal[0] * c.shear_force[1] - c.normal[1] * c.shear_force[0];
}

inline hs_pose pose_at(double x, double y, double z = 0, double w = 1) { return {{x, y, 0}, {0, 0, z, w}}; }

}  // namespace halfspace_test
