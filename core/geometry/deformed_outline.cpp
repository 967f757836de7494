#include "geometry/deformed_outline.h"

#include <Eigen/LU>

namespace halfspace {
namespace {

std::size_t vertices_of(const Outline<2>& o) { return std::size_t(Outline<2>::padded(o.count)); }
std::size_t vertices_of(const Outline<3>& o) { return std::size_t(Outline<3>::padded(o.vertex_count())); }
std::size_t halfspaces_of(const Outline<2>& o) { return vertices_of(o); }
std::size_t halfspaces_of(const Outline<3>& o) { return std::size_t(Outline<3>::padded(o.face_count())); }

template <int D>
void deform_components(const Outline<D>& own, const Tensor<D>& gradient, double* components) {
  const std::size_t vertices = vertices_of(own), halfspaces = halfspaces_of(own);
  double* normals = components + D * vertices;
  map_vectors(gradient, own.x, vertices, components);
  map_vectors(Tensor<D>(gradient.inverse().transpose()), own.nx, halfspaces, normals);
  // Normalized: the normals are no longer of unit length, and the offsets are scaled by the same factor.
  double* offset = normals + D * halfspaces;
  for (std::size_t i = 0; i < halfspaces; ++i) {
    Eigen::Map<Vector<D>, 0, Eigen::InnerStride<>> normal(normals + i,
                                                          Eigen::InnerStride<>(std::ptrdiff_t(halfspaces)));
    const double length = normal.norm();
    normal /= length;
    offset[i] = own.offset[i] / length;
  }
}

}  // namespace

std::size_t component_count(const Outline<2>& outline) { return 5 * vertices_of(outline); }
std::size_t component_count(const Outline<3>& outline) {
  return 3 * vertices_of(outline) + 4 * halfspaces_of(outline);
}

Outline<2> deformed(const Outline<2>& own, const Tensor<2>& gradient, double* components) {
  deform_components(own, gradient, components);
  const std::size_t n = vertices_of(own);
  const double* c = components;
  return {own.count, c, c + n, c + 2 * n, c + 3 * n, c + 4 * n};
}

Outline<3> deformed(const Outline<3>& own, const Tensor<3>& gradient, double* components) {
  deform_components(own, gradient, components);
  const std::size_t v = vertices_of(own), f = halfspaces_of(own);
  const double *c = components, *n = c + 3 * v;
  return {own.topology, c, c + v, c + 2 * v, n, n + f, n + 2 * f, n + 3 * f, nullptr};
}

}  // namespace halfspace
