// Shapes from raw numbers: what is accepted is a convex shape, and the parts of a cut add up to it.

#include <algorithm>

#include "fuzz/geometry.h"

namespace halfspace_fuzz {
namespace {

using namespace halfspace_test;

constexpr double epsilon = 0x1p-52;

/// How far rounding may put a vertex off a plane of its shape, for coordinates up to `reach`: in space as far
/// as a face may be from plane (flatness_tolerance() in core), and a part from its whole likewise; in the
/// plane, 8 units of rounding decide what is on a line.
double off_plane(int dimension, double reach) { return (dimension == 2 ? 32 : 1024) * epsilon * reach; }

double largest_coordinate(const double v[3]) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

double reach_of(const hs_shape_properties& p) { return largest_coordinate(p.centroid) + p.bounding_radius; }

/// Bound of its surface, in the plane of its circumference.
double surface_around(const hs_shape_properties& p) {
  constexpr double pi = 3.14159265358979323846;
  return p.dimension == 2 ? 2 * pi * p.bounding_radius : 4 * pi * p.bounding_radius * p.bounding_radius;
}

void check_properties(const hs_shape_properties& p) {
  demand(p.volume > 0 && std::isfinite(p.volume), "the size is above 0");
  demand(p.bounding_radius > 0 && std::isfinite(p.bounding_radius), "the radius is above 0");
  demand(p.shortest_edge > 0 && p.shortest_edge <= 2.001 * p.bounding_radius, "edges are within the shape");
  for (const double c : p.centroid) demand(std::isfinite(c), "the centroid is finite");
  for (int i = 0; i < 3; ++i) demand(p.second_moment[i] >= 0, "second moments are none below 0");
  for (const double m : p.second_moment) demand(std::isfinite(m), "second moments are finite");
  const std::int64_t surplus = p.dimension == 2 ? 0 : 2;
  demand(p.dimension == 2 ? p.vertex_count == p.edge_count && p.face_count == p.edge_count
                          : p.vertex_count - p.edge_count + p.face_count == surplus,
         "the counts are those of a polygon or polyhedron");
}

void check_halfspaces(const hs_shape* shape, const hs_shape_properties& p) {
  const Halfspaces planes = halfspaces_of(shape);
  const Points3 vertices = vertices_3d_of(shape);
  const double rounding = off_plane(p.dimension, reach_of(p));
  for (std::size_t f = 0; f < planes.normals.size(); ++f) {
    demand(std::abs(length(planes.normals[f]) - 1) <= 16 * epsilon, "normals have unit length");
    for (const Point3& v : vertices) {
      const double height = dot(planes.normals[f], v - vector_of(p.centroid)) - planes.offsets[f];
      demand(height <= rounding, "no vertex is before a face");
    }
  }
}

void check_faces(const hs_shape* shape, const hs_shape_properties& p) {
  for (const std::int32_t v : faces_of(shape).vertices)
    demand(v >= 0 && v < p.vertex_count, "faces are made of vertices that there are");
}

hs_shape_properties check_shape(const hs_shape* shape) {
  const hs_shape_properties p = properties_of(shape);
  check_properties(p);
  check_halfspaces(shape, p);
  check_faces(shape, p);
  return p;
}

void check_cut(hs_context* context, const hs_shape* whole, const double point[3], const double normal[3]) {
  hs_shape *behind = nullptr, *ahead = nullptr;
  const hs_status status = hs_shape_cut(whole, point, normal, &behind, &ahead);
  if (!succeeds_or(status, {HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY}, "cut")) {
    demand(!behind && !ahead, "a cut that is refused gives no parts");
    demand(*hs_context_last_error(context) != 0, "a refusal has a text");
    return;
  }
  demand(behind || ahead, "one part of a cut there always is");
  const hs_shape_properties p = properties_of(whole);
  double sum = 0;
  for (const Shape& part : {Shape(behind), Shape(ahead)})
    if (part) sum += check_shape(part.get()).volume;
  const double reach = 2 * reach_of(p) + largest_coordinate(point);
  demand(std::abs(sum - p.volume) <= off_plane(p.dimension, reach) * surface_around(p),
         "the parts of a cut add up to the whole");
}

Shape read_polyhedron(Bytes& bytes, hs_context* context) {
  Solid solid = box_3d({-1, -1, -1}, {1, 1, 1});
  if (bytes.flag()) {
    for (int changes = bytes.below(8); changes > 0; --changes)
      solid.vertices[std::size_t(bytes.below(8))] = read_point(bytes);
  } else {
    solid.vertices = read_points(bytes, 16);
    solid.faces = {};
    for (int faces = bytes.below(16); faces > 0; --faces) {
      std::vector<std::int32_t> loop(std::size_t(bytes.below(8)));
      for (std::int32_t& v : loop) v = bytes.raw<std::int8_t>();
      solid.faces.add(loop);
    }
  }
  hs_shape* shape = nullptr;
  return accepted(context, create_polyhedron(context, solid, &shape), shape, "create");
}

Shape read_from_halfspaces(Bytes& bytes, hs_context* context) {
  Points3 normals = read_points(bytes, 20);
  std::vector<double> offsets(normals.size());
  for (double& offset : offsets) offset = bytes.number();
  hs_shape* shape = nullptr;
  return accepted(context,
                  hs_polyhedron_create_from_halfspaces(context, view_of(normals), offsets.data(), &shape),
                  shape, "create_from_halfspaces");
}

Shape read_polygon(Bytes& bytes, hs_context* context) {
  const Points3 points = read_points(bytes, 24);
  hs_shape* shape = nullptr;
  return accepted(context, hs_polygon_create(context, view_of(points), &shape), shape, "create");
}

Shape read_boundary(Bytes& bytes, hs_context* context) {
  double ends[4][3];
  for (auto& end : ends) read_into(end, bytes, 2);
  const double depth = bytes.positive();
  const double* before = bytes.flag() ? ends[0] : nullptr;
  const double* after = bytes.flag() ? ends[3] : nullptr;
  hs_shape* shape = nullptr;
  return accepted(context,
                  hs_polygon_create_boundary(context, before, ends[1], ends[2], after, depth, &shape), shape,
                  "create_boundary");
}

Shape read_shape(Bytes& bytes, hs_context* context) {
  switch (bytes.below(6)) {
    case 0:
      return read_polygon(bytes, context);
    case 1:
      return read_hull(bytes, context, 2);
    case 2:
      return read_boundary(bytes, context);
    case 3:
      return read_polyhedron(bytes, context);
    case 4:
      return read_hull(bytes, context, 3);
    default:
      return read_from_halfspaces(bytes, context);
  }
}

void check_cleaning(Bytes& bytes, hs_context* context) {
  Points3 points = read_points(bytes, 24);
  Points3 cleaned = points;
  std::int64_t count = -1;
  const hs_status status = hs_polygon_clean(context, view_of(points), bytes.positive_or(0),
                                            mutable_view_of(cleaned), &count, nullptr);
  if (succeeds_or(status, {HS_ERROR_ARGUMENT}, "clean"))
    demand(count >= 0 && count <= std::int64_t(points.size()), "cleaning adds no vertex");
}

void run(Bytes bytes) {
  const Context context = make_context();
  if (bytes.byte() == 0) check_cleaning(bytes, context.get());
  const Shape shape = read_shape(bytes, context.get());
  if (!shape) return;
  const hs_shape_properties p = check_shape(shape.get());
  for (int cuts = bytes.below(4); cuts > 0; --cuts) {
    double point[3], normal[3];
    read_into(point, bytes, p.dimension);
    read_into(normal, bytes, p.dimension);
    check_cut(context.get(), shape.get(), point, normal);
  }
}

}  // namespace
}  // namespace halfspace_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  halfspace_fuzz::run({data, size});
  return 0;
}
