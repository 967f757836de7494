#pragma once

// Polyhedra through the C API: owners, views and the few conversions that every test in space needs. No test
// logic.

#include <cmath>
#include <random>

#include "capi/handles.h"
#include "oracles/vector_3d.h"

namespace halfspace_test {

using Random = std::mt19937_64;

inline double uniform_between(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

inline hs_view view_of(const Points3& p) {
  if (p.empty()) return {};
  return {&p[0].x, &p[0].y, &p[0].z, sizeof(Point3), std::int64_t(p.size())};
}

inline hs_mutable_view mutable_view_of(Points3& p) {
  if (p.empty()) return {};
  return {&p[0].x, &p[0].y, &p[0].z, sizeof(Point3), std::int64_t(p.size())};
}

/// Faces as the API takes them.
struct Faces {
  Faces() = default;
  Faces(std::initializer_list<std::vector<std::int32_t>> loops) {
    for (const std::vector<std::int32_t>& loop : loops) add(loop);
  }
  void add(const std::vector<std::int32_t>& loop) {
    sizes.push_back(std::int32_t(loop.size()));
    vertices.insert(vertices.end(), loop.begin(), loop.end());
  }

  std::vector<std::int32_t> sizes;
  std::vector<std::int32_t> vertices;
};

struct Solid {
  Points3 vertices;
  Faces faces;
};

/// Vertex i is at the low (high) end of x, y, z where bit 0, 1, 2 of i is clear (set).
inline Points3 box_corners(const Point3& low, const Point3& high) {
  Points3 corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  return corners;
}

/// Faces -z, +z, -y, +y, -x, +x.
inline Solid box_3d(const Point3& low, const Point3& high) {
  return {box_corners(low, high),
          {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
}

inline Solid cube(double side = 1) {
  const double half = side / 2;
  return box_3d({-half, -half, -half}, {half, half, half});
}

inline hs_status create_polyhedron(hs_context* context, const Solid& solid, hs_shape** shape) {
  return hs_polyhedron_create(context, view_of(solid.vertices), solid.faces.sizes.data(),
                              std::int64_t(solid.faces.sizes.size()), solid.faces.vertices.data(), shape);
}

inline Shape make_polyhedron(hs_context* context, const Solid& solid) {
  hs_shape* shape = nullptr;
  require_ok(create_polyhedron(context, solid, &shape), context);
  return Shape(shape);
}

inline Shape make_hull(hs_context* context, const Points3& points) {
  hs_shape* shape = nullptr;
  require_ok(hs_polyhedron_create_hull(context, view_of(points), &shape), context);
  return Shape(shape);
}

/// Uniform on the unit sphere.
inline Point3 random_direction(Random& random) {
  for (;;) {
    const Point3 p = {uniform_between(random, -1, 1), uniform_between(random, -1, 1),
                      uniform_between(random, -1, 1)};
    if (length(p) > 0.1 && length(p) <= 1) return unit(p);
  }
}

/// Points on a sphere: all of them are vertices of their hull.
inline Points3 round_points(Random& random, int count, double radius = 1) {
  Points3 points;
  for (int i = 0; i < count; ++i) points.push_back(radius * random_direction(random));
  return points;
}

inline Points3 vertices_3d_of(const hs_shape* shape) {
  Points3 vertices(std::size_t(properties_of(shape).vertex_count));
  if (hs_shape_get_vertices(shape, mutable_view_of(vertices), nullptr) != HS_OK)
    throw std::runtime_error("no vertices");
  return vertices;
}

inline Faces faces_of(const hs_shape* shape) {
  const hs_shape_properties p = properties_of(shape);
  std::vector<std::int32_t> first(std::size_t(p.face_count) + 1);
  Faces faces;
  faces.vertices.resize(std::size_t(2 * p.edge_count));
  if (hs_shape_get_faces(shape, first.data(), std::int64_t(first.size()), faces.vertices.data(),
                         std::int64_t(faces.vertices.size()), nullptr, nullptr) != HS_OK)
    throw std::runtime_error("no faces");
  for (std::size_t f = 0; f + 1 < first.size(); ++f) faces.sizes.push_back(first[f + 1] - first[f]);
  return faces;
}

struct Halfspaces {
  Points3 normals;
  std::vector<double> offsets;
};

inline Halfspaces halfspaces_of(const hs_shape* shape) {
  const std::size_t count = std::size_t(properties_of(shape).face_count);
  Halfspaces h{Points3(count), std::vector<double>(count)};
  if (hs_shape_get_halfspaces(shape, mutable_view_of(h.normals), h.offsets.data(), nullptr) != HS_OK)
    throw std::runtime_error("no half-spaces");
  return h;
}

inline hs_pose pose_at(const Point3& position, const Point3& axis = {0, 0, 1}, double angle = 0) {
  const double s = std::sin(angle / 2), c = std::cos(angle / 2);
  const Point3 u = unit(axis);
  return {{position.x, position.y, position.z}, {s * u.x, s * u.y, s * u.z, c}};
}

/// A direction as the pose turns it.
inline Point3 turned(const hs_pose& pose, const Point3& v) {
  const Point3 q = {pose.rotation[0], pose.rotation[1], pose.rotation[2]};
  const double w = pose.rotation[3];
  const Point3 across = 2.0 * cross(q, v);
  return v + w * across + cross(q, across);
}

/// Vertices where a pose puts them.
inline Points3 placed(const hs_shape* shape, const hs_pose& pose) {
  const hs_shape_properties p = properties_of(shape);
  const Point3 centroid = {p.centroid[0], p.centroid[1], p.centroid[2]};
  Points3 points = vertices_3d_of(shape);
  for (Point3& v : points)
    v = turned(pose, v - centroid) + Point3{pose.position[0], pose.position[1], pose.position[2]};
  return points;
}

inline Point3 vector_of(const double v[3]) { return {v[0], v[1], v[2]}; }

inline hs_contact detect_pair(const hs_shape* a, const hs_pose& pose_a, const hs_shape* b,
                              const hs_pose& pose_b, hs_pair_cache* cache = nullptr) {
  hs_contact contact{};
  const hs_status status = hs_pair_detect(a, &pose_a, b, &pose_b, nullptr, cache, &contact);
  if (status != HS_OK) throw std::runtime_error(hs_status_string(status));
  return contact;
}

}  // namespace halfspace_test
