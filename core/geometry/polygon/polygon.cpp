#include <algorithm>
#include <cmath>

#include "geometry/fingerprint.h"
#include "geometry/polygon/check.h"
#include "geometry/shape.h"

namespace halfspace {

Shape<2>::Shape(std::span<const Vector<2>> vertices, Memory* memory)
    : count_(int(vertices.size())), components_(std::size_t(5 * Outline<2>::padded(count_)), memory) {
  point_outline();
  Array<Vector<2>> ordered(vertices.begin(), vertices.end(), memory);
  set_vertices(ordered);
}

Shape<2>::Shape(const Shape& other, Memory* memory)
    : ShapeMeasures(other),
      count_(other.count_),
      area_(other.area_),
      second_moment_(other.second_moment_),
      components_(other.components_, memory) {
  point_outline();
}

void Shape<2>::set_vertices(std::span<Vector<2>> vertices) {
  if (is_clockwise(vertices)) std::reverse(vertices.begin(), vertices.end());
  measure(vertices);
  store(vertices);
  measure_thickness();
  fingerprint_ = fingerprint_of(outline_);
}

/// Moments by triangles from the first vertex. Coordinates are differences, so that the distance from the
/// origin costs no accuracy, and all areas are positive, so that there is no cancellation.
void Shape<2>::measure(std::span<const Vector<2>> vertices) {
  const Vector<2>& origin = vertices[0];
  Vector<2> first_moment = Vector<2>::Zero();
  area_ = 0;
  for (int i = 1; i + 1 < count_; ++i) {
    const Vector<2> p = vertices[std::size_t(i)] - origin;
    const Vector<2> q = vertices[std::size_t(i) + 1] - origin;
    const double triangle = 0.5 * cross(p, q);
    area_ += triangle;
    first_moment += triangle * (p + q) / 3;
  }
  const Vector<2> to_centroid = first_moment / area_;
  centroid_ = origin + to_centroid;

  second_moment_.setZero();
  for (int i = 1; i + 1 < count_; ++i) {
    // Triangle with corners a, b, c about the centroid: A/12 ((a+b+c)(a+b+c)^T + aa^T + bb^T + cc^T).
    const Vector<2> a = -to_centroid;
    const Vector<2> b = (vertices[std::size_t(i)] - origin) - to_centroid;
    const Vector<2> c = (vertices[std::size_t(i) + 1] - origin) - to_centroid;
    const Vector<2> sum = a + b + c;
    const double weight = 0.5 * cross(b - a, c - a) / 12;
    const auto product = [&](int r, int s) {
      return sum[r] * sum[s] + a[r] * a[s] + b[r] * b[s] + c[r] * c[s];
    };
    second_moment_ += weight * Eigen::Vector3d(product(0, 0), product(1, 1), product(0, 1));
  }
}

void Shape<2>::store(std::span<const Vector<2>> vertices) {
  const int stride = Outline<2>::padded(count_);
  double* x = components_.data();
  double* y = x + stride;
  double* nx = y + stride;
  double* ny = nx + stride;
  double* offset = ny + stride;

  shortest_edge_ = HUGE_VAL;
  longest_edge_ = bounding_radius_ = 0;
  for (int i = 0; i < count_; ++i) {
    const Vector<2>& here = vertices[std::size_t(i)];
    const Vector<2> edge = vertices[std::size_t(i + 1 == count_ ? 0 : i + 1)] - here;
    const double length = edge.stableNorm();
    // Relative to the rounded centroid: the difference of close numbers is exact, so that adjacent shapes
    // remain adjacent anywhere.
    const Vector<2> local = here - centroid_;
    x[i] = local.x();
    y[i] = local.y();
    nx[i] = edge.y() / length;
    ny[i] = -edge.x() / length;
    // From the midpoint of the edge, so that a mirrored shape has the same bits, mirrored.
    const Vector<2> middle = local + 0.5 * edge;
    offset[i] = nx[i] * middle.x() + ny[i] * middle.y();
    bounding_radius_ = std::max(bounding_radius_, local.norm());
    shortest_edge_ = std::min(shortest_edge_, length);
    longest_edge_ = std::max(longest_edge_, length);
  }
  if (stride != count_) {
    for (double* component : {x, y, nx, ny, offset}) component[count_] = component[count_ - 1];
  }
}

void Shape<2>::point_outline() {
  const int stride = Outline<2>::padded(count_);
  const double* const x = components_.data();
  outline_ = {count_, x, x + stride, x + 2 * stride, x + 3 * stride, x + 4 * stride};
}

/// Rotating calipers (Shamos 1978): from edge to edge, the farthest vertex moves on around the polygon.
void Shape<2>::measure_thickness() {
  const auto depth = [&](int edge, int vertex) {
    return outline_.offset[edge] - outline_.normal(edge).dot(outline_.vertex(vertex));
  };
  thickness_ = HUGE_VAL;
  for (int edge = 0, farthest = 2; edge < count_; ++edge) {
    for (int left = count_; left > 0; --left) {
      const int next = outline_.next(farthest);
      if (depth(edge, next) < depth(edge, farthest)) break;
      farthest = next;
    }
    thickness_ = std::min(thickness_, depth(edge, farthest));
  }
}

}  // namespace halfspace
