#include "geometry/polyhedron/polyhedron.h"

#include <algorithm>
#include <cmath>

#include "geometry/fingerprint.h"
#include "geometry/precise.h"
#include "geometry/shape.h"
#include "geometry/support.h"

namespace halfspace {

double largest_coordinate(std::span<const Vector<3>> vertices) {
  double largest = 0;
  for (const Vector<3>& v : vertices) largest = std::max(largest, v.cwiseAbs().maxCoeff());
  return largest;
}

namespace {

/// Calls visit(weight, a, b, c) for every triangle of the surface: corners relative to the first vertex, and
/// six times the volume of the tetrahedron with it (so that integers stay integers). Faces at the first
/// vertex are skipped, as their volumes are 0.
template <class Visit>
void for_each_tetrahedron(const Polyhedron& polyhedron, Visit visit) {
  const Vector<3>& origin = polyhedron.vertices[0];
  for (std::int32_t f = 0; f < polyhedron.face_count(); ++f) {
    const auto loop = polyhedron.loop(f);
    if (std::find(loop.begin(), loop.end(), 0) != loop.end()) continue;
    const Vector<3>& a = polyhedron.corner(f, 0);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const Vector<3>& b = polyhedron.corner(f, i);
      const Vector<3>& c = polyhedron.corner(f, i + 1);
      const double weight = precise_cross_product(a, b, c).dot(a - origin);
      visit(weight, Vector<3>(a - origin), Vector<3>(b - origin), Vector<3>(c - origin));
    }
  }
}

}  // namespace

Shape<3>::Shape(const Polyhedron& polyhedron, Memory* memory)
    : topology_(polyhedron, memory),
      components_(std::size_t(3 * Outline<3>::padded(vertex_count()) + 4 * Outline<3>::padded(face_count())),
                  memory) {
  set_polyhedron(polyhedron);
  if (vertex_count() > few_vertices) outline_.gauss_map = &gauss_map_.emplace(outline_, memory);
}

/// A Gauss map of the former vertices is of no use; a new one would cost more than most searches until the
/// next motion, which walk instead.
void Shape<3>::set_polyhedron(const Polyhedron& polyhedron) {
  gauss_map_.reset();
  measure(polyhedron);
  store(polyhedron);
  measure_edges();
  measure_faces();
  measure_thickness();
  fingerprint_ = fingerprint_of(outline_);
}

/// Moments by tetrahedra from the first vertex to the triangles of the other faces. Coordinates are
/// differences, so that the distance from the origin costs no accuracy, and all volumes are positive, so that
/// there is no cancellation.
void Shape<3>::measure(const Polyhedron& polyhedron) {
  double weights = 0;
  Vector<3> weighted_corners = Vector<3>::Zero();
  for_each_tetrahedron(polyhedron,
                       [&](double weight, const Vector<3>& a, const Vector<3>& b, const Vector<3>& c) {
                         weights += weight;
                         weighted_corners += weight * (a + b + c);
                       });
  volume_ = weights / 6;
  const Vector<3> to_centroid = weighted_corners / (4 * weights);
  centroid_ = polyhedron.vertices[0] + to_centroid;

  second_moment_.setZero();
  for_each_tetrahedron(
      polyhedron, [&](double weight, const Vector<3>& a, const Vector<3>& b, const Vector<3>& c) {
        // Corners p about the centroid, s their sum: V/20 (s s^T + sum of p p^T).
        const Vector<3> corners[4] = {-to_centroid, a - to_centroid, b - to_centroid, c - to_centroid};
        const Vector<3> sum = corners[0] + corners[1] + corners[2] + corners[3];
        const auto product = [&](int r, int s) {
          double total = sum[r] * sum[s];
          for (const Vector<3>& p : corners) total += p[r] * p[s];
          return total;
        };
        const double products[6] = {product(0, 0), product(1, 1), product(2, 2),
                                    product(0, 1), product(1, 2), product(2, 0)};
        for (int i = 0; i < 6; ++i) second_moment_[i] += weight / 120 * products[i];
      });
}

void Shape<3>::store(const Polyhedron& polyhedron) {
  const int vertices = vertex_count();
  const int faces = face_count();
  const int vertex_stride = Outline<3>::padded(vertices);
  const int face_stride = Outline<3>::padded(faces);
  double* x = components_.data();
  double* y = x + vertex_stride;
  double* z = y + vertex_stride;
  double* nx = z + vertex_stride;
  double* ny = nx + face_stride;
  double* nz = ny + face_stride;
  double* offset = nz + face_stride;
  outline_ = {&topology_.view(), x, y, z, nx, ny, nz, offset, nullptr};

  bounding_radius_ = 0;
  for (int i = 0; i < vertex_stride; ++i) {
    // Relative to the rounded centroid: the difference of close numbers is exact, so that adjacent shapes
    // remain adjacent anywhere.
    const Vector<3> local = polyhedron.vertices[std::size_t(std::min(i, vertices - 1))] - centroid_;
    x[i] = local.x();
    y[i] = local.y();
    z[i] = local.z();
    bounding_radius_ = std::max(bounding_radius_, local.norm());
  }
  for (int f = 0; f < face_stride; ++f) {
    const int face = std::min(f, faces - 1);
    const Vector<3>& normal = polyhedron.normals[std::size_t(face)];
    nx[f] = normal.x();
    ny[f] = normal.y();
    nz[f] = normal.z();
    // The mean of the lowest and highest corner, so that their order does not matter.
    double lowest = HUGE_VAL;
    double highest = -HUGE_VAL;
    for (const std::int32_t v : polyhedron.loop(face)) {
      const double height = normal.dot(outline_.vertex(v));
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
    offset[f] = 0.5 * (lowest + highest);
  }
}

void Shape<3>::measure_edges() {
  const Topology& t = topology();
  shortest_edge_ = HUGE_VAL;
  longest_edge_ = 0;
  for (int e = 0; e < t.edge_count; ++e) {
    const Vector<3> edge = outline_.vertex(t.edge_end[e]) - outline_.vertex(t.edge_start[e]);
    const double length = edge.stableNorm();
    shortest_edge_ = std::min(shortest_edge_, length);
    longest_edge_ = std::max(longest_edge_, length);
  }
}

void Shape<3>::measure_faces() {
  const Topology& t = topology();
  largest_face_ = 0;
  for (int f = 0; f < t.face_count; ++f) {
    const std::int32_t* const loop = t.face_vertex + t.first_of_face[f];
    const int corners = t.first_of_face[f + 1] - t.first_of_face[f];
    const Vector<3> first = outline_.vertex(loop[0]);
    Vector<3> twice_area = Vector<3>::Zero();
    for (int i = 1; i + 1 < corners; ++i)
      twice_area += cross_product(outline_.vertex(loop[i]) - first, outline_.vertex(loop[i + 1]) - first);
    largest_face_ = std::max(largest_face_, 0.5 * twice_area.stableNorm());
  }
}

void Shape<3>::measure_thickness() {
  thickness_ = HUGE_VAL;
  int deepest = 0;
  for (int f = 0; f < face_count(); ++f) {
    const Support farthest = walk_to_deepest(outline_, outline_.normal(f), deepest);
    deepest = farthest.vertex;
    thickness_ = std::min(thickness_, outline_.offset[f] - farthest.height);
  }
}

Eigen::Matrix3d Shape<3>::inertia() const {
  const auto& m = second_moment_;
  Eigen::Matrix3d inertia;
  inertia << m[1] + m[2], -m[3], -m[5],  //
      -m[3], m[2] + m[0], -m[4],         //
      -m[5], -m[4], m[0] + m[1];
  return inertia;
}

Polyhedron polyhedron_of(const Shape<3>& shape, Memory* memory) {
  Polyhedron polyhedron(memory);
  const Topology& t = shape.topology();
  const Outline<3>& outline = shape.outline();
  for (int v = 0; v < t.vertex_count; ++v)
    polyhedron.vertices.push_back(outline.vertex(v) + shape.centroid());
  polyhedron.first_of_face.assign(t.first_of_face, t.first_of_face + t.face_count + 1);
  polyhedron.face_vertices.assign(t.face_vertex, t.face_vertex + 2 * t.edge_count);
  for (int f = 0; f < t.face_count; ++f) polyhedron.normals.push_back(outline.normal(f));
  return polyhedron;
}

}  // namespace halfspace
