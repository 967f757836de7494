#include "block/bond/common_face.h"

#include <algorithm>
#include <cmath>

#include "block/blocks.h"
#include "geometry/polygon/clip.h"
#include "geometry/tolerances.h"

namespace halfspace {
namespace {

/// Do two faces lie in one plane, with opposite normals?
template <int D>
bool are_opposite(const Outline<D>& a, int f, const Outline<D>& b, int g, const Vector<D>& to_b,
                  double reach) {
  const Vector<D> normal = a.normal(f);
  return (normal + b.normal(g)).norm() <= strictly_parallel &&
         std::abs(normal.dot(to_b) - b.offset[g] - a.offset[f]) <= reach;
}

/// The overlap of two edges on one line, with the points of Simpson's rule.
double add_points(const Outline<2>& a, int f, const Outline<2>& b, int g, const Vector<2>& to_b,
                  Array<FacePoint<2>>& points) {
  const Vector<2> start = a.vertex(f), along = (a.vertex(a.next(f)) - start).normalized();
  const double length = (a.vertex(a.next(f)) - start).norm();
  const double one = (b.vertex(g) + to_b - start).dot(along),
               other = (b.vertex(b.next(g)) + to_b - start).dot(along);
  const double from = std::max(0.0, std::min(one, other)), to = std::min(length, std::max(one, other));
  if (!(to > from)) return 0;
  points.push_back({start + from * along, (to - from) / 6});
  points.push_back({start + 0.5 * (from + to) * along, 4 * (to - from) / 6});
  points.push_back({start + to * along, (to - from) / 6});
  return to - from;
}

/// The vertices of a face in coordinates of its plane.
Array<Vector<2>> flattened(const Outline<3>& block, int face, const Vector<3>& shift, const Vector<3>& x,
                           const Vector<3>& y, Memory* memory) {
  const Topology& topology = *block.topology;
  Array<Vector<2>> corners(memory);
  for (int k = topology.first_of_face[face]; k < topology.first_of_face[face + 1]; ++k) {
    const Vector<3> corner = block.vertex(topology.face_vertex[k]) + shift;
    corners.emplace_back(corner.dot(x), corner.dot(y));
  }
  return corners;
}

/// The overlap of two faces in one plane.
Array<Vector<2>> common_polygon(const Array<Vector<2>>& one, const Array<Vector<2>>& other) {
  Array<Vector<2>> common(one, one.get_allocator());
  for (std::size_t i = 0; i < other.size(); ++i) {
    const Vector<2>& from = other[i];
    const Vector<2> way = other[(i + 1) % other.size()] - from;
    Array<Vector<2>> rest(one.get_allocator());
    clip<Vector<2>>(
        common, [&](const Vector<2>& p) { return -cross(way, p - from); }, 0,
        [&](const Vector<2>& p) { rest.push_back(p); });
    common.swap(rest);
  }
  return common;
}

/// Integrates over a polygon, divided into triangles from its first corner, with weights 1/20, 2/15 and 9/20
/// of a triangle's area at corners, midpoints of sides and centroid. Calls add(place, area) once per point.
template <class Add>
double integrate(const Array<Vector<2>>& polygon, Add add) {
  Memory* memory = polygon.get_allocator().resource();
  const std::size_t n = polygon.size();
  Array<double> at_corner(n, 0, memory), at_spoke(n, 0, memory), at_rim(n, 0, memory);
  double whole = 0;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double area = 0.5 * cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    if (!(area > 0)) continue;
    whole += area;
    for (const std::size_t corner : {std::size_t(0), i, i + 1}) at_corner[corner] += area / 20;
    at_spoke[i] += area * 2 / 15;
    at_spoke[i + 1] += area * 2 / 15;
    at_rim[i] += area * 2 / 15;
    add((polygon[0] + polygon[i] + polygon[i + 1]) / 3, area * 9 / 20);
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (at_corner[i] > 0) add(polygon[i], at_corner[i]);
    if (at_spoke[i] > 0) add(0.5 * (polygon[0] + polygon[i]), at_spoke[i]);
    if (at_rim[i] > 0) add(0.5 * (polygon[i] + polygon[i + 1]), at_rim[i]);
  }
  return whole;
}

/// The overlap of two faces in one plane.
double add_points(const Outline<3>& a, int f, const Outline<3>& b, int g, const Vector<3>& to_b,
                  Array<FacePoint<3>>& points) {
  Memory* memory = points.get_allocator().resource();
  const Topology& topology = *a.topology;
  const int first = topology.first_of_face[f];
  const Vector<3> normal = a.normal(f), origin = a.vertex(topology.face_vertex[first]);
  const Vector<3> x = (a.vertex(topology.face_vertex[first + 1]) - origin).normalized(),
                  y = cross_product(normal, x);
  Array<Vector<2>> other = flattened(b, g, to_b - origin, x, y, memory);
  std::reverse(other.begin(), other.end());  // counter-clockwise seen from outside of a
  return integrate(common_polygon(flattened(a, f, -origin, x, y, memory), other),
                   [&](const Vector<2>& at, double area) {
                     points.push_back({origin + at.x() * x + at.y() * y, area});
                   });
}

}  // namespace

template <int D>
std::optional<CommonFace<D>> common_face(const Blocks<D>& blocks, std::int32_t block_a, std::int32_t block_b,
                                         Memory* memory) {
  const auto [a, b, to_b] = blocks.placed(block_a, block_b);
  const double reach =
      touch_reach * std::min(blocks.radius[std::size_t(block_a)], blocks.radius[std::size_t(block_b)]);
  const double least = D == 2 ? reach : reach * reach;  // smaller areas are rounding errors
  std::optional<CommonFace<D>> common;
  double largest = 0;
  Array<FacePoint<D>> points(memory);
  for (int f = 0; f < a.face_count(); ++f) {
    for (int g = 0; g < b.face_count(); ++g) {
      if (!are_opposite<D>(a, f, b, g, to_b, reach)) continue;
      points.clear();
      const double area = add_points(a, f, b, g, to_b, points);
      if (area <= least) continue;
      if (!common) common.emplace(CommonFace<D>{a.normal(f), Array<FacePoint<D>>(memory)});
      if (area > largest) common->normal = a.normal(f);
      largest = std::max(largest, area);
      common->points.insert(common->points.end(), points.begin(), points.end());
    }
  }
  return common;
}

template std::optional<CommonFace<2>> common_face(const Blocks<2>&, std::int32_t, std::int32_t, Memory*);
template std::optional<CommonFace<3>> common_face(const Blocks<3>&, std::int32_t, std::int32_t, Memory*);

}  // namespace halfspace
