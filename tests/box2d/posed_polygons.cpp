#include "posed_polygons.h"

#include <algorithm>
#include <cmath>

#include "benchmarks/box2d_polygon.h"

namespace halfspace_test {
namespace {

using Real = long double;

struct RealPoint {
  Real x, y;
};

RealPoint operator-(const RealPoint& p, const RealPoint& q) { return {p.x - q.x, p.y - q.y}; }
Real dot(const RealPoint& p, const RealPoint& q) { return p.x * q.x + p.y * q.y; }

/// Relative to the position of polygon a.
std::vector<RealPoint> laid(const b2PolygonShape& shape, const b2Transform& at, const b2Vec2& origin) {
  const Real length = std::sqrt(Real(at.q.c) * at.q.c + Real(at.q.s) * at.q.s);
  const Real c = at.q.c / length, s = at.q.s / length;
  const RealPoint position{Real(at.p.x) - origin.x, Real(at.p.y) - origin.y};
  std::vector<RealPoint> points;
  for (int i = 0; i < shape.m_count; ++i) {
    const Real x = shape.m_vertices[i].x, y = shape.m_vertices[i].y;
    points.push_back({position.x + (c * x - s * y), position.y + (s * x + c * y)});
  }
  return points;
}

FaceGap gap_of(int owner, std::size_t edge, const std::vector<RealPoint>& of_owner,
               const std::vector<RealPoint>& of_other) {
  const RealPoint from = of_owner[edge], along = of_owner[(edge + 1) % of_owner.size()] - from;
  const Real length = std::sqrt(dot(along, along));
  const RealPoint tangent{along.x / length, along.y / length}, normal{tangent.y, -tangent.x};
  const auto lower = [&](const RealPoint& p, const RealPoint& q) { return dot(normal, p) < dot(normal, q); };
  const RealPoint deepest = *std::min_element(of_other.begin(), of_other.end(), lower) - from;
  const Real s = dot(tangent, deepest);
  return {owner, int(edge), dot(normal, deepest), std::max(-s, s - length)};
}

}  // namespace

std::vector<FaceGap> face_gaps(const PosedPolygons& pair) {
  const auto a = laid(pair.a, pair.transform_a(), pair.at_a), b = laid(pair.b, pair.transform_b(), pair.at_a);
  std::vector<FaceGap> gaps;
  for (std::size_t i = 0; i < a.size(); ++i) gaps.push_back(gap_of(0, i, a, b));
  for (std::size_t i = 0; i < b.size(); ++i) gaps.push_back(gap_of(1, i, b, a));
  return gaps;
}

FaceGap largest(const std::vector<FaceGap>& gaps) {
  const auto less = [](const FaceGap& p, const FaceGap& q) { return p.gap < q.gap; };
  return *std::max_element(gaps.begin(), gaps.end(), less);
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
