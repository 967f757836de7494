#include "mesh/convex_solid.h"

#include <algorithm>
#include <cmath>

#include "mesh/mesh_fault.h"
#include "text.h"
#include "vector.h"

namespace halfspace::cli {
namespace {

std::vector<Point> scaled(std::vector<Point> points, double scale) {
  for (Point& p : points) p = times(scale, p);
  return points;
}

double size_of(const std::vector<Point>& points) {
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(), [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    size = std::max(size, (*high)[axis] - (*low)[axis]);
  }
  return size;
}

/// How far a face's corners lie below that plane of the hull to which they are all nearest.
double depth_below(const std::vector<HalfSpace>& hull, const std::vector<Point>& vertices,
                   const std::vector<int>& face) {
  double least = INFINITY;
  for (const HalfSpace& plane : hull) {
    double depth = 0;
    for (int corner : face) {
      const Point& p = vertices[static_cast<std::size_t>(corner)];
      depth = std::max(depth, plane.offset - dot(plane.normal, p));
    }
    least = std::min(least, depth);
  }
  return least;
}

/// How often the surface winds around the hull, by its volume as a sum of tetrahedra from the origin.
double windings(const std::vector<Point>& vertices, const std::vector<std::vector<int>>& faces,
                double volume_of_hull) {
  double volume = 0;
  for (const std::vector<int>& face : faces) {
    const auto corner = [&](std::size_t i) { return vertices[static_cast<std::size_t>(face[i])]; };
    const Point a = corner(0);
    for (std::size_t i = 2; i < face.size(); ++i) {
      const Point b = corner(i - 1), c = corner(i);
      volume += dot(a, cross(b, c)) / 6;
    }
  }
  return volume / volume_of_hull;
}

}  // namespace

Shape make_convex(const Context& context, const Solid& solid, double scale) {
  std::vector<Point> vertices = scaled(solid.vertices, scale);
  Shape hull;
  try {
    hull = make_hull(context, vertices);
  } catch (const LibraryError& error) {
    if (error.status != HS_ERROR_ARGUMENT && error.status != HS_ERROR_GEOMETRY) throw;
    throw MeshFault(solid.place, error.reason());
  }
  const hs_shape_properties properties = properties_of(context, hull);
  const Point centroid = point_of(properties.centroid);
  for (Point& p : vertices) p = minus(p, centroid);  // half-spaces have it at their origin

  const double tolerance = 0x1p-16 * size_of(vertices);
  const std::vector<HalfSpace> halfspaces = halfspaces_of(context, hull);
  for (const std::vector<int>& face : solid.faces) {
    const double depth = depth_below(halfspaces, vertices, face);
    if (depth <= tolerance) continue;
    throw MeshFault(solid.place, "not convex: the face with a corner at " +
                                     described(solid.vertices[static_cast<std::size_t>(face[0])]) +
                                     " lies up to " + rounded(depth, 3) +
                                     " m inside the hull; allowed: convex solids");
  }
  // All faces lie on the hull: they cover it a whole number of times.
  if (std::abs(std::abs(windings(vertices, solid.faces, properties.volume)) - 1) > 0.5)
    throw MeshFault(solid.place, "a surface folded onto itself; allowed: convex solids");
  return hull;
}

bool is_inside_out(const Solid& solid) {
  std::vector<Point> vertices = solid.vertices;
  const Point origin = vertices[0];
  for (Point& p : vertices) p = minus(p, origin);
  return windings(vertices, solid.faces, 1) < 0;
}

}  // namespace halfspace::cli
