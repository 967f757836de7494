// hs_pair_distance on random pairs of polygons and polyhedra, family by family.
//
//   closest_points [pairs] [seed]      default 100000 pairs, all families together
//
// A distance is proven by two bounds in long double: points of both shapes are that close, and a slab normal
// to the reported direction separates the shapes by as much. Fails when the bounds differ by more than
// rounding, or when the distance is 0 for separated shapes or not 0 for shapes in contact.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "capi/polyhedra.h"
#include "oracles/random_pairs.h"
#include "oracles/random_pairs_3d.h"

namespace halfspace_test {
namespace {

using Real = long double;
using Point = Vector3<Real>;

// Of the library's bounds, in units of 2^-53 times the size of the pair: dot products of turned vertices, and
// weights of corners.
constexpr double rounding_bound = 48;

/// A shape at its pose, in long double.
struct Body {
  Body(const hs_shape* shape, const hs_pose& at) : turn(at) {
    const hs_shape_properties properties = properties_of(shape);
    std::vector<double> x(std::size_t(properties.vertex_count)), y(x), z(x);
    const hs_mutable_view view{x.data(), y.data(), z.data(), sizeof(double), properties.vertex_count};
    if (hs_shape_get_vertices(shape, view, nullptr) != HS_OK) throw std::runtime_error("no vertices");
    const double* c = properties.centroid;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Point local{Real(x[i]) - c[0], Real(y[i]) - c[1], Real(z[i]) - c[2]};
      arms.push_back(1 / turn.length_squared() * turn.turned(local));
    }
    std::vector<double> nx(std::size_t(properties.face_count)), ny(nx), nz(nx);
    offsets.resize(nx.size());
    const hs_mutable_view normal{nx.data(), ny.data(), nz.data(), sizeof(double), properties.face_count};
    if (hs_shape_get_halfspaces(shape, normal, offsets.data(), nullptr) != HS_OK)
      throw std::runtime_error("no half-spaces");
    for (std::size_t f = 0; f < nx.size(); ++f)
      normals.push_back(1 / turn.length_squared() * turn.turned({nx[f], ny[f], nz[f]}));
    radius = properties.bounding_radius;
  }
  Real support(const Point& direction) const {
    Real largest = -HUGE_VALL;
    for (const Point& arm : arms) largest = std::max(largest, dot(direction, arm));
    return largest;
  }
  /// The height of a point, relative to the centroid, over the highest half-space.
  Real height(const Point& arm) const {
    Real largest = -HUGE_VALL;
    for (std::size_t f = 0; f < normals.size(); ++f)
      largest = std::max(largest, dot(normals[f], arm) - offsets[f]);
    return largest;
  }

  Turn3<Real> turn;
  std::vector<Point> arms, normals;
  std::vector<double> offsets;
  double radius;
};

Point point(const double (&p)[3]) { return {p[0], p[1], p[2]}; }
Real norm(const Point& v) { return std::sqrt(dot(v, v)); }

struct Tally {
  long pairs = 0;
  long touching = 0;
  long wrong = 0;          // 0 for separated shapes, or not 0 in contact
  long unproven = 0;       // beyond rounding
  double worst_bound = 0;  // difference of the bounds, in units of rounding
  double worst_point = 0;  // height of a point above its shape, likewise

  void add(const Tally& t) {
    pairs += t.pairs;
    touching += t.touching;
    wrong += t.wrong;
    unproven += t.unproven;
    worst_bound = std::max(worst_bound, t.worst_bound);
    worst_point = std::max(worst_point, t.worst_point);
  }
  bool is_clean() const { return wrong == 0 && unproven == 0; }
};

void judge(const hs_shape* shape_a, const hs_pose& pose_a, const hs_shape* shape_b, const hs_pose& pose_b,
           const hs_context* context, Tally& tally) {
  hs_closest_points found;
  hs_contact contact{};
  require_ok(hs_pair_distance(shape_a, &pose_a, shape_b, &pose_b, &found), context);
  require_ok(hs_pair_detect(shape_a, &pose_a, shape_b, &pose_b, nullptr, nullptr, &contact), context);
  const Body a(shape_a, pose_a), b(shape_b, pose_b);
  const Point at_a = point(pose_a.position), at_b = point(pose_b.position), apart = at_b - at_a;
  const Real unit = 0x1p-53L * (a.radius + b.radius + norm(apart));
  const Real unit_of_places = unit + 0x1p-53L * (norm(at_a) + norm(at_b));

  ++tally.pairs;
  const bool touches = contact.type != HS_CONTACT_NONE;
  tally.touching += touches;
  tally.wrong += touches != (found.distance == 0);
  const Point on_a = point(found.point_a), on_b = point(found.point_b), normal = point(found.normal);
  const Real upper = norm(on_b - on_a);
  const Real lower = touches ? 0 : dot(normal, apart) - b.support(Real(-1) * normal) - a.support(normal);
  const double bound = double(std::max({std::abs(found.distance - lower) / unit,
                                        (upper - lower) / unit_of_places, (lower - upper) / unit_of_places}));
  const double height = double(std::max(a.height(on_a - at_a), b.height(on_b - at_b)) / unit_of_places);
  tally.worst_bound = std::max(tally.worst_bound, bound);
  tally.worst_point = std::max(tally.worst_point, height);
  const bool is_proven = bound <= rounding_bound && height <= rounding_bound;
  if (!is_proven && ++tally.unproven <= 2) {
    std::printf("UNPROVEN: distance %.17g, bounds %.17Lg and %.17Lg, off by %.3g, height %.3g, unit %.3Lg\n",
                found.distance, lower, upper, bound, height, unit);
  }
}

Tally run(Family family, long pairs, std::uint64_t seed) {
  const Context context = make_context();
  Random random(seed + std::uint64_t(family));
  Tally tally;
  while (tally.pairs < pairs) {
    const PolygonPair polygons = draw_polygons(family, random);
    const Shape a = try_shape(context.get(), polygons.a), b = try_shape(context.get(), polygons.b);
    if (!a || !b) continue;
    const PosePair poses = draw_poses(family, polygons, a.get(), b.get(), random);
    judge(a.get(), poses.a, b.get(), poses.b, context.get(), tally);
  }
  return tally;
}

Shape made_of(const Polyhedron& drawn, hs_context* context) {
  hs_shape* shape = nullptr;
  require_ok(hs_polyhedron_create_hull(context, view_of(drawn.vertices), &shape), context);
  return Shape(shape);
}

/// The pose of a shape whose centroid is not the centre of what was drawn.
hs_pose pose_of(const hs_shape* shape, const Polyhedron& drawn, hs_pose pose) {
  const hs_shape_properties properties = properties_of(shape);
  const double* c = properties.centroid;
  const Point3 moved = turned(pose, {c[0] - drawn.centre.x, c[1] - drawn.centre.y, c[2] - drawn.centre.z});
  pose.position[0] += moved.x;
  pose.position[1] += moved.y;
  pose.position[2] += moved.z;
  return pose;
}

Tally run(Family3 family, long pairs, std::uint64_t seed) {
  const Context context = make_context();
  Random3 random(seed + std::uint64_t(family));
  Tally tally;
  while (tally.pairs < pairs) {
    const PolyhedronPair drawn = draw_polyhedra(family, random);
    const Shape a = made_of(drawn.a, context.get()), b = made_of(drawn.b, context.get());
    for (int i = 0; i < 4 && tally.pairs < pairs; ++i) {
      const PosePair3 poses = draw_poses(family, drawn, random);
      judge(a.get(), pose_of(a.get(), drawn.a, poses.a), b.get(), pose_of(b.get(), drawn.b, poses.b),
            context.get(), tally);
    }
  }
  return tally;
}

void print(const char* name, const Tally& t) {
  std::printf("%-20s %8ld %8ld %6ld %8ld %10.2f %10.2f\n", name, t.pairs, t.touching, t.wrong, t.unproven,
              t.worst_bound, t.worst_point);
}

}  // namespace
}  // namespace halfspace_test

int main(int argc, char** argv) {
  using namespace halfspace_test;
  const long pairs = argc > 1 ? std::atol(argv[1]) : 100000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  std::printf("%-20s %8s %8s %6s %8s %10s %10s\n", "family", "pairs", "touching", "wrong", "unproven",
              "bounds", "points");
  Tally all;
  const long families = long(std::size(all_families) + std::size(all_families_3d));
  for (const Family family : all_families) {
    const Tally tally = run(family, pairs / families, seed);
    print(name_of(family), tally);
    all.add(tally);
  }
  for (const NamedFamily3& family : all_families_3d) {
    const Tally tally = run(family.family, pairs / families, seed);
    print(family.name, tally);
    all.add(tally);
  }
  print("all", all);
  return all.is_clean() ? EXIT_SUCCESS : EXIT_FAILURE;
}
