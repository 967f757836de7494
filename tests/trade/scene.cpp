#include "scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace halfspace_trade {
namespace {

/// About the centroid, by the triangles that it makes with the edges.
Mass mass_of_polygon(const std::vector<Vector>& corners, double density) {
  double area = 0, second_moment = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector &p = corners[i], &q = corners[(i + 1) % corners.size()];
    const double twice = p[0] * q[1] - p[1] * q[0];
    const double squares = p[0] * p[0] + p[0] * q[0] + q[0] * q[0] + p[1] * p[1] + p[1] * q[1] + q[1] * q[1];
    area += twice / 2;
    second_moment += twice * squares / 12;
  }
  return {density * area, {0, 0, density * second_moment}};
}

}  // namespace

std::vector<Vector> corners_of(const Body& body, int dimension) {
  if (!body.corners.empty()) return body.corners;
  const double x = body.size[0] / 2, y = body.size[1] / 2, z = dimension == 3 ? body.size[2] / 2 : 0;
  std::vector<Vector> corners = {{-x, -y, -z}, {x, -y, -z}, {x, y, -z}, {-x, y, -z}};
  if (dimension == 3)
    for (std::size_t i = 0; i < 4; ++i) corners.push_back({corners[i][0], corners[i][1], z});
  return corners;
}

Mass mass_of(const Body& body, int dimension) {
  if (dimension == 2) return mass_of_polygon(corners_of(body, 2), body.density);
  if (!body.corners.empty()) throw std::logic_error("the mass of a hull");
  const auto& [x, y, z] = body.size;
  const double mass = body.density * x * y * z;
  return {mass, {mass * (y * y + z * z) / 12, mass * (x * x + z * z) / 12, mass * (x * x + y * y) / 12}};
}

const Body& typical_body(const Scene& scene) {
  for (const Body& body : scene.bodies)
    if (!body.is_fixed) return body;
  throw std::logic_error("nothing moves");
}

double face_stiffness(const Scene& scene, double indentation) {
  const double mass = mass_of(typical_body(scene), scene.dimension).mass;
  const double of_impact = mass * std::pow(scene.impact_speed / indentation, 2);
  return std::max(scene.load / indentation, of_impact);
}

}  // namespace halfspace_trade
