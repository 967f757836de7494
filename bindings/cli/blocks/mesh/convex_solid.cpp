#include "blocks/mesh/convex_solid.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"
#include "common/vector.h"

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

/// The winding number of the surface around its hull: the ratio of their volumes, as a sum of tetrahedra from
/// the first vertex.
double windings(const std::vector<Point>& vertices, const std::vector<std::vector<int>>& faces,
                double volume_of_hull) {
  double volume = 0;
  for (const std::vector<int>& face : faces) {
    const auto corner = [&](std::size_t i) {
      return minus(vertices[static_cast<std::size_t>(face[i])], vertices[0]);
    };
    const Point a = corner(0);
    for (std::size_t i = 2; i < face.size(); ++i) {
      const Point b = corner(i - 1), c = corner(i);
      volume += dot(a, cross(b, c)) / 6;
    }
  }
  return volume / volume_of_hull;
}

double default_tolerance(const Solid& solid, double scale, const std::vector<Point>& vertices) {
  return std::min(2 * solid.last_digit * scale, 0x1p-7 * size_of(vertices));
}

[[noreturn]] void refuse(const Solid& solid, const hs_fit_report& report, double tolerance,
                         const LibraryError& error) {
  if (report.fault.kind == HS_FAULT_VERTEX_OUTSIDE_FACE)
    throw MeshFault(solid.place, "a surface folded onto itself; allowed: convex solids");
  if (report.fault.kind != HS_FAULT_BEYOND_TOLERANCE) throw MeshFault(solid.place, error.reason());
  std::string text = "not convex: a dent " + rounded(report.deviation, 3) + " m deep at " +
                     described(solid.vertices[static_cast<std::size_t>(report.fault.vertex)]) +
                     "; allowed: dents up to the tolerance, " + rounded(tolerance, 3) + " m";
  if (report.sufficient_tolerance > 0)
    text += "; tolerance = " + rounded(report.sufficient_tolerance, 2) + " suffices";
  throw NotConvex(solid.place, text, report.sufficient_tolerance);
}

}  // namespace

ConvexSolid make_convex(const Context& context, const Solid& solid, double scale,
                        std::optional<double> tolerance) {
  const std::vector<Point> vertices = scaled(solid.vertices, scale);
  const double within = tolerance.value_or(default_tolerance(solid, scale, vertices));
  ConvexSolid made{.shape = nullptr, .tolerance = within};
  try {
    made.shape = make_fitted(context, vertices, FaceList(solid.faces), within, made.report);
  } catch (const LibraryError& error) {
    if (error.status != HS_ERROR_ARGUMENT && error.status != HS_ERROR_GEOMETRY) throw;
    refuse(solid, made.report, within, error);
  }
  // All faces lie on the shape: they cover it a whole number of times.
  const double volume = properties_of(context, made.shape).volume;
  if (std::abs(std::abs(windings(vertices, solid.faces, volume)) - 1) > 0.5)
    throw MeshFault(solid.place, "a surface folded onto itself; allowed: convex solids");
  return made;
}

bool is_inside_out(const Solid& solid) { return windings(solid.vertices, solid.faces, 1) < 0; }

}  // namespace halfspace::cli
