#include "detect/expanding_polytope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "detect/indexed_lanes.h"

namespace halfspace {

ExpandingPolytope::ExpandingPolytope(const Corner* tetrahedron) {
  double size = 0;
  for (int i = 0; i < 4; ++i) size = std::max(size, tetrahedron[i].at.cwiseAbs().maxCoeff());
  rounding_ = 8 * std::numeric_limits<double>::epsilon() * size;
  // Counter-clockwise seen from outside when corner 3 is behind the plane of the others.
  const Vector<3> base = tetrahedron[0].at;
  const double volume =
      cross_product(Vector<3>(tetrahedron[1].at - base), Vector<3>(tetrahedron[2].at - base))
          .dot(tetrahedron[3].at - base);
  add_corner(tetrahedron[0]);
  add_corner(tetrahedron[volume > 0 ? 2 : 1]);
  add_corner(tetrahedron[volume > 0 ? 1 : 2]);
  add_corner(tetrahedron[3]);
  facet_count_ = 4;
  put_two({0, 1, 2}, 0, {0, 3, 1}, 1);
  put_two({1, 3, 2}, 2, {2, 3, 0}, 3);
}

void ExpandingPolytope::add_corner(const Corner& c) {
  edges_from_[corner_count_][0] = edges_from_[corner_count_][1] = 0;
  corners_[corner_count_++] = c;
}

/// Facets are made two at a time.
void ExpandingPolytope::put_two(const Triangle& first, int first_place, const Triangle& second,
                                int second_place) {
  struct Points {
    TwoLanes x, y, z;
    Points operator-(const Points& o) const { return {x - o.x, y - o.y, z - o.z}; }
    Points cross(const Points& o) const { return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x}; }
    TwoLanes dot(const Points& o) const { return x * o.x + y * o.y + z * o.z; }
  };
  const auto corners = [&](int i) {
    const Vector<3>&p = corners_[first[i]].at, &q = corners_[second[i]].at;
    return Points{{p.x(), q.x()}, {p.y(), q.y()}, {p.z(), q.z()}};
  };
  const Points p = corners(0);
  const Points normal = (corners(1) - p).cross(corners(2) - p);
  const TwoLanes square = normal.dot(normal);
  const TwoLanes length = {std::sqrt(square[0]), std::sqrt(square[1])};
  // Three corners on a line span no plane: never the nearest, and nothing lies beyond it.
  const TwoLanes inverse = square > both(0) ? both(1) / length : both(0);
  const TwoLanes offset = square > both(0) ? inverse * normal.dot(p) : both(HUGE_VAL);
  const auto put = [&](const Triangle& triangle, int f, int lane) {
    triangles_[f] = triangle;
    nx_[f] = (inverse * normal.x)[lane];
    ny_[f] = (inverse * normal.y)[lane];
    nz_[f] = (inverse * normal.z)[lane];
    offset_[f] = offset[lane];
    nearest_ = offset_[f] < offset_[nearest_] ? f : nearest_;
  };
  put(first, first_place, 0);
  put(second, second_place, 1);
}

/// Never the nearest from now on, and nothing lies beyond it.
void ExpandingPolytope::forget_facet(int f) {
  nx_[f] = ny_[f] = nz_[f] = 0;
  offset_[f] = HUGE_VAL;
}

ExpandingPolytope::Facet ExpandingPolytope::nearest() const {
  const int f = nearest_;
  const auto corner = [&](int i) { return &corners_[triangles_[f][i]]; };
  return {{corner(0), corner(1), corner(2)}, {nx_[f], ny_[f], nz_[f]}, offset_[f]};
}

/// Lists the facets that a point lies beyond, and makes the nearest of the others the nearest. Which they are
/// is as good as random: no branches.
int ExpandingPolytope::find_visible(const Vector<3>& from, int* visible) {
  if (facet_count_ % 2 == 1) forget_facet(facet_count_);  // is read beside the last one
  const TwoLanes x = both(from.x()), y = both(from.y()), z = both(from.z());
  TwoLanes index = {0, 1};
  IndexedLanes least = {both(HUGE_VAL), index};
  int count = 0;
  for (int f = 0; f < facet_count_; f += 2) {
    const TwoLanes offset = two_at(offset_ + f);
    const TwoLanes height = two_at(nx_ + f) * x + two_at(ny_ + f) * y + two_at(nz_ + f) * z;
    const TwoLanes clearance = (offset + both(rounding_)) - height;
    const unsigned is_beyond = signs(clearance);
    visible[count] = f;
    count += int(is_beyond & 1);
    visible[count] = f + 1;
    count += int(is_beyond >> 1);
    least = smaller(least, {clearance < both(0) ? both(HUGE_VAL) : offset, index});
    index += both(2);
  }
  nearest_ = int(smaller(least, {exchanged(least.value), exchanged(least.index)}).index[0]);
  return count;
}

/// The horizon are the edges of facets seen whose other facet is not: an edge between two that are seen comes
/// up in both directions.
int ExpandingPolytope::find_horizon(const int* visible, int visible_count, Edge* horizon) {
  const auto bit = [](int corner) { return std::uint64_t(1) << (corner % 64); };
  int edge_count = 0;
  for (int v = 0; v < visible_count; ++v) {
    const Triangle t = triangles_[visible[v]];
    for (const Edge& e : {Edge{t[0], t[1]}, Edge{t[1], t[2]}, Edge{t[2], t[0]}}) {
      edges_from_[e.from][e.to / 64] |= bit(e.to);
      horizon[edge_count++] = e;
    }
  }
  int count = 0;
  for (int i = 0; i < edge_count; ++i) {
    const Edge e = horizon[i];
    horizon[count] = e;
    count += (edges_from_[e.to][e.from / 64] & bit(e.from)) == 0;
  }
  for (int v = 0; v < visible_count; ++v) {
    const Triangle t = triangles_[visible[v]];
    for (int i = 0; i < 3; ++i) edges_from_[t[i]][0] = edges_from_[t[i]][1] = 0;
  }
  return count;
}

/// The facets seen make room for those between the horizon and the new corner.
void ExpandingPolytope::expand(const Corner& c) {
  int visible[most_facets + 1];
  const int visible_count = find_visible(c.at, visible);
  Edge horizon[3 * most_facets];
  const int horizon_count = find_horizon(visible, visible_count, horizon);
  for (int v = 0; v < visible_count; ++v) forget_facet(visible[v]);
  const int tip = corner_count_;
  add_corner(c);
  // Rounding may tear the surface, but there are never more facets than there is room for.
  const int added = std::min(horizon_count, visible_count + most_facets - facet_count_);
  const auto facet = [&](int e) { return Triangle(horizon[e].from, horizon[e].to, tip); };
  const auto place = [&](int e) { return e < visible_count ? visible[e] : facet_count_ + e - visible_count; };
  for (int e = 0; e < added; e += 2) {
    const int other = std::min(e + 1, added - 1);
    put_two(facet(e), place(e), facet(other), place(other));
  }
  facet_count_ += std::max(0, added - visible_count);
}

}  // namespace halfspace
