#include "posed_polygons.h"

#include <algorithm>
#include <cmath>

#include "benchmarks/box2d_polygon.h"

namespace halfspace_test {

std::vector<FaceGap> face_gaps(const PosedPolygons& pair) {
  return face_gaps(vertices_of(pair.a), pair.transform_a(), vertices_of(pair.b), pair.transform_b());
}

FaceGap reference_of(const b2Manifold& manifold, const PosedPolygons& pair,
                     const std::vector<FaceGap>& gaps) {
  const int owner = manifold.type == b2Manifold::e_faceA ? 0 : 1;
  const b2PolygonShape& polygon = owner == 0 ? pair.a : pair.b;
  const auto likeness = [&](const FaceGap& g) {
    return g.owner == owner ? b2Dot(polygon.m_normals[g.edge], manifold.localNormal) : -2;
  };
  const auto less = [&](const FaceGap& p, const FaceGap& q) { return likeness(p) < likeness(q); };
  return *std::max_element(gaps.begin(), gaps.end(), less);
}

PosedPolygons draw_polygons(double from_origin, double wanted_gap, Random& random) {
  using halfspace_benchmark::pi;
  using halfspace_benchmark::uniform;
  const auto direction = [&](double length) {
    const double angle = uniform(random, -pi, pi);
    return Point{length * std::cos(angle), length * std::sin(angle)};
  };
  PosedPolygons pair;
  pair.a = halfspace_benchmark::random_box2d_shape(0.4, 0.6, random);
  pair.b = halfspace_benchmark::random_box2d_shape(0.4, 0.6, random);
  pair.angle_a = float(uniform(random, -pi, pi));
  pair.angle_b = float(uniform(random, -pi, pi));
  const Point place = direction(from_origin), way = direction(1);
  pair.at_a = {float(place.x), float(place.y)};
  // The largest gap is convex in the distance, and below the wanted one where the centres meet.
  double too_near = 0, too_far = 3;
  for (int i = 0; i < 40; ++i) {
    const double middle = (too_near + too_far) / 2;
    pair.at_b = {float(place.x + middle * way.x), float(place.y + middle * way.y)};
    (largest(face_gaps(pair)).gap < wanted_gap ? too_near : too_far) = middle;
  }
  return pair;
}

}  // namespace halfspace_test
