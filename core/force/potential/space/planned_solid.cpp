#include "force/potential/space/planned_solid.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// Grows with the angle of a direction in the plane, and jumps where that does.
double angle_of(double x, double y) {
  const double sum = std::abs(x) + std::abs(y);
  return sum > 0 ? std::copysign(1 - x / sum, y) : 0;
}

}  // namespace

/// One that has all corners of others takes their place: where faces of both blocks lie in one plane.
void PlannedSolid::add_facet(const CornerSet& corners, const Vector<3>& outward) {
  if (corners.count() < 3) return;
  for (const Facet& facet : facets_)
    if (corners.is_within(facet.corners)) return;
  std::erase_if(facets_, [&](const Facet& facet) { return facet.corners.is_within(corners); });
  facets_.emplace_back().outward = outward;
  facets_.back().corners = corners;
}

void PlannedSolid::go_around(Facet& facet) const {
  Vector<3> center = Vector<3>::Zero();
  facet.corners.for_each([&](int c) { center += at_[std::size_t(c)]; });
  center /= facet.corners.count();
  const Vector<3> normal = facet.outward.normalized();
  Vector<3> axis = Vector<3>::Zero();
  axis[std::abs(normal.x()) < 0.5 ? 0 : 1] = 1;
  const Vector<3> u = cross_product(normal, axis), w = cross_product(normal, u);
  double angle[most_plan_corners];
  std::uint8_t* end = facet.around;
  facet.corners.for_each([&](int c) {
    const Vector<3> arm = at_[std::size_t(c)] - center;
    angle[c] = angle_of(u.dot(arm), w.dot(arm));
    *end++ = std::uint8_t(c);
  });
  std::sort(facet.around, end, [&](int c, int d) { return angle[c] < angle[d]; });
}

bool PlannedSolid::close() {
  CornerSet to[most_plan_corners], from[most_plan_corners];
  for (Facet& facet : facets_) {
    go_around(facet);
    const int count = facet.corners.count();
    for (int i = 0; i < count; ++i) {
      const int c = facet.around[i], d = facet.around[i + 1 < count ? i + 1 : 0];
      if (to[c].has(d)) return false;
      to[c].add(d);
      from[d].add(c);
    }
  }
  return std::equal(to, to + at_.size(), from);
}

int PlannedSolid::top() const {
  int facets_at[most_plan_corners] = {};
  for (const Facet& facet : facets_) facet.corners.for_each([&](int c) { ++facets_at[c]; });
  return int(std::max_element(facets_at, facets_at + at_.size()) - facets_at);
}

double PlannedSolid::volume_of(int top, int p, int q, int r) const {
  const auto seen_from_top = [&](int c) { return Vector<3>(at_[std::size_t(c)] - at_[std::size_t(top)]); };
  return seen_from_top(p).dot(cross_product(seen_from_top(q), seen_from_top(r))) / 6;
}

}  // namespace halfspace
