#include "recording/centroid.h"

#include <algorithm>

namespace halfspace::viewer {
namespace {

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }

double triple(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

}  // namespace

Point centroid_of(const std::vector<Point>& vertices, const std::vector<std::vector<int>>& faces,
                  int dimension) {
  const Point& origin = vertices.front();
  const auto at = [&](int vertex) { return minus(vertices[static_cast<std::size_t>(vertex)], origin); };
  Point sum{};
  double size = 0;
  // The triangles of a fan, in 3D the tetrahedra between them and the origin.
  for (const std::vector<int>& face : faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Point a = at(face[0]), b = at(face[i]), c = at(face[i + 1]);
      const double part = dimension == 2 ? cross(minus(b, a), minus(c, a)) : triple(a, b, c);
      size += part;
      for (std::size_t axis = 0; axis < 3; ++axis)
        sum[axis] += part * (a[axis] + b[axis] + c[axis]) / (dimension + 1);
    }
  }
  Point centroid = origin;
  for (std::size_t axis = 0; axis < 3 && size != 0; ++axis) {
    centroid[axis] += sum[axis] / size;
    // Rounding may lose a sliver's size: the centroid then stays in the box of the block.
    const auto [low, high] = std::minmax_element(
        vertices.begin(), vertices.end(), [&](const Point& p, const Point& q) { return p[axis] < q[axis]; });
    if (!(centroid[axis] >= (*low)[axis] && centroid[axis] <= (*high)[axis]))
      centroid[axis] = ((*low)[axis] + (*high)[axis]) / 2;
  }
  return centroid;
}

}  // namespace halfspace::viewer
