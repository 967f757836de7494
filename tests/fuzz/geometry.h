#pragma once

// Shapes, poses and motions from the bytes of a fuzzer.

#include "capi/polyhedra.h"
#include "fuzz/bytes.h"
#include "fuzz/demand.h"

namespace halfspace_fuzz {

using halfspace_test::Context;
using halfspace_test::Faces;
using halfspace_test::Point3;
using halfspace_test::Points3;
using halfspace_test::Shape;
using halfspace_test::World;

inline Point3 read_point(Bytes& bytes) {
  const double x = bytes.number(), y = bytes.number();
  return {x, y, bytes.number()};
}

inline Points3 read_points(Bytes& bytes, int most) {
  Points3 points(std::size_t(bytes.between(0, most)));
  for (Point3& p : points) p = read_point(bytes);
  return points;
}

/// Null where the call refuses, which it may for what the bytes hold. The shape is read when the call has
/// been made: it is no value.
inline Shape accepted(hs_context* context, hs_status status, hs_shape* const& shape, const char* call) {
  if (succeeds_or(status, {HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY}, call)) {
    demand(shape != nullptr, "a shape that is accepted is there");
    return Shape(shape);
  }
  demand(shape == nullptr, "a shape that is refused is not written");
  demand(*hs_context_last_error(context) != 0, "a refusal has a text");
  return nullptr;
}

inline Shape hull_of(hs_context* context, int dimension, const Points3& points) {
  hs_shape* shape = nullptr;
  const hs_status status = dimension == 2
                               ? hs_polygon_create_hull(context, halfspace_test::view_of(points), &shape)
                               : hs_polyhedron_create_hull(context, halfspace_test::view_of(points), &shape);
  return accepted(context, status, shape, "create_hull");
}

/// A box, or the hull of points; null where the library refuses the points.
inline Shape read_hull(Bytes& bytes, hs_context* context, int dimension) {
  if (bytes.flag()) return hull_of(context, dimension, read_points(bytes, 24));
  const Point3 half = {bytes.positive(), bytes.positive(), bytes.positive()};
  return hull_of(context, dimension, halfspace_test::box_corners({-half.x, -half.y, -half.z}, half));
}

/// Turned by a quaternion of unit length unless its numbers are none.
inline hs_pose read_pose(Bytes& bytes, int dimension) {
  const Point3 position = read_point(bytes);
  hs_pose pose = {{position.x, position.y, dimension == 2 ? 0 : position.z}, {0, 0, 0, 1}};
  if (bytes.flag()) return pose;
  for (int i = dimension == 2 ? 2 : 0; i < 4; ++i) pose.rotation[i] = bytes.number();
  const double* q = pose.rotation;
  const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  for (double& component : pose.rotation) component /= length;
  return pose;
}

inline void read_into(double vector[3], Bytes& bytes, int dimension) {
  const Point3 p = read_point(bytes);
  vector[0] = p.x;
  vector[1] = p.y;
  vector[2] = dimension == 2 ? 0 : p.z;
}

}  // namespace halfspace_fuzz
