#include "face_gaps.h"

#include <algorithm>
#include <cmath>

namespace halfspace_test {
namespace {

using Real = long double;
using RealPoint = Direction;

RealPoint operator-(const RealPoint& p, const RealPoint& q) { return {p.x - q.x, p.y - q.y}; }
RealPoint operator-(const RealPoint& p) { return {-p.x, -p.y}; }
Real dot(const RealPoint& p, const RealPoint& q) { return p.x * q.x + p.y * q.y; }
RealPoint unit(const RealPoint& p) {
  const Real length = std::sqrt(dot(p, p));
  return {p.x / length, p.y / length};
}

/// A transform that takes points relative to an origin near by.
class Laying {
 public:
  Laying(const b2Transform& at, const b2Vec2& origin)
      : turn_(unit({at.q.c, at.q.s})), position_{Real(at.p.x) - origin.x, Real(at.p.y) - origin.y} {}

  RealPoint turned(Real x, Real y) const { return {turn_.x * x - turn_.y * y, turn_.y * x + turn_.x * y}; }
  RealPoint laid(Real x, Real y) const {
    const RealPoint from_body = turned(x, y);
    return {position_.x + from_body.x, position_.y + from_body.y};
  }
  std::vector<RealPoint> laid(const Points& polygon) const {
    std::vector<RealPoint> points;
    for (const Point& p : polygon) points.push_back(laid(p.x, p.y));
    return points;
  }

 private:
  RealPoint turn_;  // cosine, sine
  RealPoint position_;
};

FaceGap gap_of(int owner, std::size_t edge, const std::vector<RealPoint>& of_owner,
               const std::vector<RealPoint>& of_other) {
  const RealPoint from = of_owner[edge], along = of_owner[(edge + 1) % of_owner.size()] - from;
  const Real length = std::sqrt(dot(along, along));
  const RealPoint tangent = unit(along), normal{tangent.y, -tangent.x};
  const auto lower = [&](const RealPoint& p, const RealPoint& q) { return dot(normal, p) < dot(normal, q); };
  const RealPoint deepest = *std::min_element(of_other.begin(), of_other.end(), lower) - from;
  const Real s = dot(tangent, deepest);
  return {owner, int(edge), dot(normal, deepest), std::max(-s, s - length), owner == 0 ? normal : -normal};
}

}  // namespace

std::vector<FaceGap> face_gaps(const Points& a, const b2Transform& at_a, const Points& b,
                               const b2Transform& at_b) {
  const auto of_a = Laying(at_a, at_a.p).laid(a), of_b = Laying(at_b, at_a.p).laid(b);
  std::vector<FaceGap> gaps;
  for (std::size_t i = 0; i < of_a.size(); ++i) gaps.push_back(gap_of(0, i, of_a, of_b));
  for (std::size_t i = 0; i < of_b.size(); ++i) gaps.push_back(gap_of(1, i, of_b, of_a));
  return gaps;
}

FaceGap largest(const std::vector<FaceGap>& gaps) {
  const auto less = [](const FaceGap& p, const FaceGap& q) { return p.gap < q.gap; };
  return *std::max_element(gaps.begin(), gaps.end(), less);
}

Points vertices_of(const b2PolygonShape& shape) {
  Points vertices;
  for (int i = 0; i < shape.m_count; ++i) vertices.push_back({shape.m_vertices[i].x, shape.m_vertices[i].y});
  return vertices;
}

StatedContact stated_by(const b2Manifold& manifold, const b2Transform& at_a, const b2Transform& at_b) {
  const bool is_of_a = manifold.type == b2Manifold::e_faceA;
  const Laying owner(is_of_a ? at_a : at_b, at_a.p), other(is_of_a ? at_b : at_a, at_a.p);
  const RealPoint normal = unit(owner.turned(manifold.localNormal.x, manifold.localNormal.y));
  const RealPoint on_face = owner.laid(manifold.localPoint.x, manifold.localPoint.y);
  Real least = INFINITY;
  for (int i = 0; i < manifold.pointCount; ++i) {
    const b2Vec2& local = manifold.points[i].localPoint;
    least = std::min(least, dot(normal, other.laid(local.x, local.y) - on_face));
  }
  return {least, is_of_a ? normal : -normal};
}

}  // namespace halfspace_test
