// hs_pair_distance on random pairs of polygons and polyhedra, family by family.
//
//   closest_points [pairs]      of each family; default 10000
//
// A distance is proven by two bounds in long double: a point of each shape, as far from one another, and a
// slab normal to the reported direction, as thick, which separates the shapes. Fails when bounds differ by
// more than 1e-12 of the pair's size, as narrow triangles of the Minkowski difference magnify rounding, or
// when the distance is 0 for separated shapes or not 0 for shapes in contact.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <vector>

#include "capi/handles.h"

namespace halfspace_test {
namespace {

using Real = long double;
using Vector = std::array<Real, 3>;

Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector sum(const Vector& a, const Vector& b, Real factor = 1) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real norm(const Vector& v) { return std::sqrt(dot(v, v)); }
Vector vector(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

/// By the quaternion of a pose, which is a unit one but for rounding.
Vector turned(const hs_pose& pose, const Vector& v) {
  const Vector axis = {pose.rotation[0], pose.rotation[1], pose.rotation[2]};
  const Real w = pose.rotation[3], length = dot(axis, axis) + w * w;
  return sum(v, sum(cross(axis, cross(axis, v)), cross(axis, v), w), 2 / length);
}

/// A shape at its pose: vertices and half-spaces relative to its centroid.
struct Body {
  Body(const hs_shape* shape, const hs_pose& pose) {
    hs_shape_properties properties;
    require(hs_shape_get_properties(shape, &properties, sizeof properties));
    std::vector<double> values(3 * std::size_t(std::max(properties.vertex_count, properties.face_count)));
    const auto view = [&](std::int64_t count) {
      return hs_mutable_view{&values[0], &values[1], &values[2], 3 * sizeof(double), count};
    };
    const auto at = [&](std::size_t i) {
      return Vector{values[3 * i], values[3 * i + 1], values[3 * i + 2]};
    };
    require(hs_shape_get_vertices(shape, view(properties.vertex_count), nullptr));
    for (std::size_t v = 0; v < std::size_t(properties.vertex_count); ++v)
      arms.push_back(turned(pose, sum(at(v), vector(properties.centroid), -1)));
    offsets.resize(std::size_t(properties.face_count));
    require(hs_shape_get_halfspaces(shape, view(properties.face_count), offsets.data(), nullptr));
    for (std::size_t f = 0; f < offsets.size(); ++f) normals.push_back(turned(pose, at(f)));
    radius = properties.bounding_radius;
  }

  static void require(hs_status status) {
    if (status != HS_OK) throw std::runtime_error(hs_status_string(status));
  }

  Real support(const Vector& direction) const {
    Real largest = -HUGE_VALL;
    for (const Vector& arm : arms) largest = std::max(largest, dot(direction, arm));
    return largest;
  }

  /// The height of a point above the shape: at most 0 inside.
  Real height(const Vector& arm) const {
    Real largest = -HUGE_VALL;
    for (std::size_t f = 0; f < normals.size(); ++f)
      largest = std::max(largest, dot(normals[f], arm) - offsets[f]);
    return largest;
  }

  std::vector<Vector> arms, normals;
  std::vector<double> offsets;
  Real radius;
};

struct Family {
  const char* name;
  int dimension, points;
  double thickness;  // of the shape, along its last axis
  double distance;   // of the pair from the origin
};

constexpr Family families[] = {
    {"triangles", 2, 3, 1, 0},          {"polygons", 2, 12, 1, 0},         {"flat polygons", 2, 12, 1e-4, 0},
    {"polygons away", 2, 8, 1, 1e6},    {"tetrahedra", 3, 4, 1, 0},        {"polyhedra", 3, 32, 1, 0},
    {"flat polyhedra", 3, 16, 1e-4, 0}, {"polyhedra away", 3, 12, 1, 1e6},
};

using Random = std::mt19937_64;

Shape draw_shape(const Family& family, hs_context* context, Random& random) {
  std::normal_distribution<double> normal;
  std::vector<std::array<double, 3>> points(std::size_t(family.points));
  for (auto& point : points) {
    double square = 0;
    for (int axis = 0; axis < family.dimension; ++axis) square += std::pow(point[axis] = normal(random), 2);
    for (double& coordinate : point) coordinate /= std::sqrt(square);
    point[std::size_t(family.dimension - 1)] *= family.thickness;
  }
  const hs_view view = {&points[0][0], &points[0][1], &points[0][2], sizeof points[0], family.points};
  hs_shape* shape = nullptr;
  const auto create = family.dimension == 2 ? hs_polygon_create_hull : hs_polyhedron_create_hull;
  return Shape(create(context, view, &shape) == HS_OK ? shape : nullptr);
}

/// Turned at random, with the centroid in a box about a point.
hs_pose draw_pose(const Family& family, Random& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  hs_pose pose{};
  double square = 0;
  for (int i = family.dimension == 2 ? 2 : 0; i < 4; ++i)
    square += std::pow(pose.rotation[i] = normal(random), 2);
  for (double& component : pose.rotation) component /= std::sqrt(square);
  for (int axis = 0; axis < family.dimension; ++axis) pose.position[axis] = family.distance + uniform(random);
  return pose;
}

struct Tally {
  long pairs = 0, touching = 0, wrong = 0;
  Real bounds = 0, height = 0;  // in units of rounding
};

void judge(const hs_shape* shape_a, const hs_pose& pose_a, const hs_shape* shape_b, const hs_pose& pose_b,
           Tally& tally) {
  hs_closest_points found;
  hs_contact contact{};
  Body::require(hs_pair_distance(shape_a, &pose_a, shape_b, &pose_b, &found));
  Body::require(hs_pair_detect(shape_a, &pose_a, shape_b, &pose_b, nullptr, nullptr, &contact));
  const Body a(shape_a, pose_a), b(shape_b, pose_b);
  const Vector at_a = vector(pose_a.position), at_b = vector(pose_b.position), apart = sum(at_b, at_a, -1);
  const Vector on_a = vector(found.point_a), on_b = vector(found.point_b), normal = vector(found.normal);
  const Real size = a.radius + b.radius + norm(apart), unit = 0x1p-53L * size;
  const Real unit_of_places = unit + 0x1p-53L * (norm(at_a) + norm(at_b));
  const bool touches = contact.type != HS_CONTACT_NONE;
  ++tally.pairs;
  tally.touching += touches;
  tally.wrong += touches != (found.distance == 0);
  const Real upper = norm(sum(on_b, on_a, -1));
  const Real lower = touches ? 0 : dot(normal, apart) - b.support(sum({}, normal, -1)) - a.support(normal);
  tally.bounds = std::max(
      {tally.bounds, std::abs(found.distance - lower) / unit, std::abs(upper - lower) / unit_of_places});
  tally.height = std::max({tally.height, a.height(sum(on_a, at_a, -1)) / unit_of_places,
                           b.height(sum(on_b, at_b, -1)) / unit_of_places});
}

Tally judge_all(const Family& family, long pairs) {
  const Context context = make_context();
  Random random(std::uint64_t(family.points) + 100 * std::uint64_t(family.dimension));
  Tally tally;
  while (tally.pairs < pairs) {
    const Shape a = draw_shape(family, context.get(), random), b = draw_shape(family, context.get(), random);
    if (!a || !b) continue;
    judge(a.get(), draw_pose(family, random), b.get(), draw_pose(family, random), tally);
  }
  return tally;
}

}  // namespace
}  // namespace halfspace_test

int main(int argc, char** argv) {
  using namespace halfspace_test;
  constexpr long double rounding_bound = 1e-12L * 0x1p53L;
  const long pairs = argc > 1 ? std::atol(argv[1]) : 10000;
  bool is_clean = true;
  std::printf("%-16s %8s %8s %6s %8s %8s\n", "family", "pairs", "touching", "wrong", "bounds", "points");
  for (const Family& family : families) {
    const Tally t = judge_all(family, pairs);
    std::printf("%-16s %8ld %8ld %6ld %8.2Lf %8.2Lf\n", family.name, t.pairs, t.touching, t.wrong, t.bounds,
                t.height);
    is_clean = is_clean && t.wrong == 0 && t.bounds <= rounding_bound && t.height <= rounding_bound;
  }
  return is_clean ? EXIT_SUCCESS : EXIT_FAILURE;
}
