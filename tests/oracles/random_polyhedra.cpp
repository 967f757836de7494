#include "oracles/random_polyhedra.h"

namespace halfspace_test {
namespace {

constexpr double pi = 3.14159265358979323846;

Point3 regular_place(int i, int vertices) {
  if (vertices == 4) {
    static constexpr double corners[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    return unit({corners[i][0], corners[i][1], corners[i][2]});
  }
  const double golden_angle = pi * (3 - std::sqrt(5.0));
  const double z = 1 - (2 * i + 1) / double(vertices);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z};
}

}  // namespace

Point3 random_direction(Random3& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return unit({x, y, z});
}

hs_pose turned_at_random(const Point3& position, Random3& random) {
  std::normal_distribution<double> normal;
  hs_pose pose{{position.x, position.y, position.z}, {}};
  double length_squared = 0;
  for (double& q : pose.rotation) {
    q = normal(random);
    length_squared += q * q;
  }
  for (double& q : pose.rotation) q /= std::sqrt(length_squared);
  return pose;
}

Point3 turned(const hs_pose& pose, const Point3& direction) {
  const Turn3<double> turn(pose);
  return (1 / turn.length_squared()) * turn.turned(direction);
}

Polyhedron box_3d(const Point3& low, const Point3& high) {
  Points3 corners;
  for (const double x : {low.x, high.x}) {
    for (const double y : {low.y, high.y}) {
      for (const double z : {low.z, high.z}) corners.push_back({x, y, z});
    }
  }
  return convex_hull(corners);
}

Polyhedron round_polyhedron(int vertices, double radius, Random3& random) {
  const double spacing = std::sqrt(4 * pi / vertices);
  Points3 points;
  for (int i = 0; i < vertices; ++i) {
    const double off = uniform_between(random, 0, spacing / 5);
    points.push_back(radius * unit(regular_place(i, vertices) + off * random_direction(random)));
  }
  return convex_hull(points);
}

}  // namespace halfspace_test
