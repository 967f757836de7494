#include <algorithm>
#include <cstddef>

#include "shape_handle.h"
#include "sized_struct.h"
#include "strided_view.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

// Common functions of both dimensions. In 2D the edges take the place of the faces.

/// The vertices of all faces, face after face: index of the first vertex of a face, and the vertex at an
/// index.
int begin_of_face(const Shape<2>&, int face) { return 2 * face; }
int begin_of_face(const Shape<3>& s, int face) { return s.topology().first_of_face[face]; }
int face_vertex(const Shape<2>& s, int place) { return (place + 1) / 2 % s.vertex_count(); }
int face_vertex(const Shape<3>& s, int place) { return s.topology().face_vertex[place]; }

int edge_start(const Shape<2>&, int edge) { return edge; }
int edge_start(const Shape<3>& s, int edge) { return s.topology().edge_start[edge]; }
int edge_end(const Shape<2>& s, int edge) { return s.outline().next(edge); }
int edge_end(const Shape<3>& s, int edge) { return s.topology().edge_end[edge]; }

double volume(const Shape<2>& s) { return s.area(); }
double volume(const Shape<3>& s) { return s.volume(); }

void write_second_moment(const Shape<2>& s, double out[6]) {
  out[0] = s.second_moment()[0];
  out[1] = s.second_moment()[1];
  out[3] = s.second_moment()[2];
}
void write_second_moment(const Shape<3>& s, double out[6]) { std::copy_n(s.second_moment().data(), 6, out); }

template <int D>
hs_shape_properties properties_of(const Shape<D>& s) {
  hs_shape_properties p{};
  p.dimension = D;
  p.vertex_count = s.vertex_count();
  p.edge_count = s.outline().edge_count();
  p.face_count = s.outline().face_count();
  p.volume = volume(s);
  write_vector(s.centroid(), p.centroid);
  write_second_moment(s, p.second_moment);
  p.bounding_radius = s.bounding_radius();
  p.shortest_edge = s.shortest_edge();
  return p;
}

}  // namespace

hs_status hs_shape_get_properties(const hs_shape* shape, hs_shape_properties* properties, size_t size) {
  return with_shape(shape, __func__, [&](const auto& s) {
    require_pointer(properties, "properties");
    require_report_size(size, offsetof(hs_shape_properties, shortest_edge) + sizeof(double));
    write_sized(properties_of(s), properties, size);
    return HS_OK;
  });
}

hs_status hs_shape_get_vertices(const hs_shape* shape, hs_mutable_view vertices, int64_t* count) {
  return with_shape(shape, __func__, [&]<int D>(const Shape<D>& s) {
    require_view<D>(vertices, "vertices");
    if (count) *count = s.vertex_count();
    return write_all(s.vertex_count(), vertices.count,
                     [&](int i) { write_point(vertices, i, s.outline().vertex(i) + s.centroid()); });
  });
}

hs_status hs_shape_get_faces(const hs_shape* shape, int32_t first_of_face[], int64_t face_capacity,
                             int32_t face_vertices[], int64_t vertex_capacity, int64_t* face_count,
                             int64_t* vertex_count) {
  return with_shape(shape, __func__, [&](const auto& s) {
    require_count(face_capacity, "face_capacity");
    require_count(vertex_capacity, "vertex_capacity");
    if (face_capacity > 0) require_pointer(first_of_face, "first_of_face");
    if (vertex_capacity > 0) require_pointer(face_vertices, "face_vertices");
    const std::int64_t faces = s.outline().face_count(), vertices = 2 * s.outline().edge_count();
    if (face_count) *face_count = faces;
    if (vertex_count) *vertex_count = vertices;
    const hs_status of_faces =
        write_all(faces + 1, face_capacity, [&](int f) { first_of_face[f] = begin_of_face(s, f); });
    const hs_status of_vertices =
        write_all(vertices, vertex_capacity, [&](int k) { face_vertices[k] = face_vertex(s, k); });
    return std::max(of_faces, of_vertices);
  });
}

hs_status hs_shape_get_edges(const hs_shape* shape, int32_t edge_vertices[], int64_t capacity,
                             int64_t* count) {
  return with_shape(shape, __func__, [&](const auto& s) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(edge_vertices, "edge_vertices");
    const std::int64_t edges = s.outline().edge_count();
    if (count) *count = edges;
    return write_all(edges, capacity, [&](int e) {
      edge_vertices[2 * e] = edge_start(s, e);
      edge_vertices[2 * e + 1] = edge_end(s, e);
    });
  });
}

hs_status hs_shape_get_halfspaces(const hs_shape* shape, hs_mutable_view normals, double offsets[],
                                  int64_t* count) {
  return with_shape(shape, __func__, [&]<int D>(const Shape<D>& s) {
    require_view<D>(normals, "normals");
    const Outline<D>& outline = s.outline();
    if (count) *count = outline.face_count();
    return write_all(outline.face_count(), normals.count, [&](int i) {
      write_point(normals, i, outline.normal(i));
      if (offsets) offsets[i] = outline.offset[i];
    });
  });
}

void hs_shape_destroy(hs_shape* shape) {
  if (!shape) return;
  if (shape->dimension() == 2) {
    destroy(shape->context, static_cast<ShapeHandle<2>*>(shape));
  } else {
    destroy(shape->context, static_cast<ShapeHandle<3>*>(shape));
  }
}
