#include "oracles/cgal_polygon.h"

#include <CGAL/Boolean_set_operations_2.h>

#include <cmath>
#include <iterator>
#include <vector>

namespace halfspace_test {

using ExactPoint = ExactKernel::Point_2;
using ExactVector = ExactKernel::Vector_2;

ExactPolygon exact_polygon(const Points& vertices) {
  ExactPolygon polygon;
  for (const Point& p : vertices) polygon.push_back(ExactPoint(p.x, p.y));
  return polygon;
}

ExactPolygon placed_exactly(const PlacedPolygon& polygon) {
  const ExactNumber z = polygon.pose.rotation[2];
  const ExactNumber w = polygon.pose.rotation[3];
  const ExactNumber length_squared = z * z + w * w;
  const ExactNumber c = (w * w - z * z) / length_squared;
  const ExactNumber s = 2 * w * z / length_squared;
  const ExactVector to_position(polygon.pose.position[0], polygon.pose.position[1]);
  ExactPolygon placed;
  for (const Point& p : *polygon.vertices) {
    const ExactVector local = ExactPoint(p.x, p.y) - ExactPoint(polygon.centroid.x, polygon.centroid.y);
    placed.push_back(CGAL::ORIGIN + to_position +
                     ExactVector(c * local.x() - s * local.y(), s * local.x() + c * local.y()));
  }
  return placed;
}

bool interiors_overlap(const ExactPolygon& a, const ExactPolygon& b) { return CGAL::do_intersect(a, b); }

ExactPolygon part_behind(const ExactPolygon& polygon, Point point, Point normal) {
  // The half-plane as a box on the line, larger than the polygon.
  const ExactPoint on_line(point.x, point.y);
  const ExactVector n(normal.x, normal.y);
  const ExactVector along(-normal.y, normal.x);
  ExactNumber reach = 1;
  for (const ExactPoint& p : polygon.vertices()) {
    const ExactVector d = p - on_line;
    reach += CGAL::abs(d * n) + CGAL::abs(d * along);
  }
  reach /= n.squared_length();
  ExactPolygon half_plane;
  half_plane.push_back(on_line - reach * along - reach * n);
  half_plane.push_back(on_line - reach * along);
  half_plane.push_back(on_line + reach * along);
  half_plane.push_back(on_line + reach * along - reach * n);
  if (half_plane.is_clockwise_oriented()) half_plane.reverse_orientation();

  std::vector<CGAL::Polygon_with_holes_2<ExactKernel>> parts;
  CGAL::intersection(polygon, half_plane, std::back_inserter(parts));
  return parts.empty() ? ExactPolygon() : parts.front().outer_boundary();
}

ExactMoments exact_moments(const ExactPolygon& polygon) {
  // Integrals of 1, x, y, xx, yy, xy over the polygon by its boundary, about the origin; then moved to the
  // centroid.
  ExactNumber area = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactPoint& p = polygon[i];
    const ExactPoint& q = polygon[(i + 1) % polygon.size()];
    const ExactNumber w = p.x() * q.y() - q.x() * p.y();
    area += w / 2;
    x += w * (p.x() + q.x()) / 6;
    y += w * (p.y() + q.y()) / 6;
    xx += w * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x()) / 12;
    yy += w * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y()) / 12;
    xy += w * (2 * p.x() * p.y() + p.x() * q.y() + q.x() * p.y() + 2 * q.x() * q.y()) / 24;
  }
  const ExactNumber cx = x / area;
  const ExactNumber cy = y / area;
  return {area, {cx, cy}, {xx - area * cx * cx, yy - area * cy * cy, xy - area * cx * cy}};
}

}  // namespace halfspace_test
