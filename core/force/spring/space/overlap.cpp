#include "force/spring/overlap.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "geometry/box.h"
#include "geometry/polygon/clip.h"
#include "narrow_phase/space/contact_plane.h"

namespace halfspace {
namespace {

/// A point of a's surface, projected along the contact's normal, and the depth of a face of b below it.
struct DepthPoint {
  Vector<2> foot;
  double depth;
};

DepthPoint between(const DepthPoint& from, const DepthPoint& to, double share) {
  return {halfspace::between(from.foot, to.foot, share), from.depth + share * (to.depth - from.depth)};
}

/// Sums over triangles with a linear depth.
struct DepthSums {
  double volume = 0;
  double depth_squared = 0;
  double base = 0;
  Vector<2> moment{0, 0};
  double polar_moment = 0;
  Vector<2> base_moment{0, 0};
  Tensor<2> base_spread = Tensor<2>::Zero();  // 12 times the integral of foot times foot^T

  void add(const DepthPoint& p, const DepthPoint& q, const DepthPoint& r, double sign) {
    const double area = 0.5 * sign * cross(q.foot - p.foot, r.foot - p.foot);
    const double sum = p.depth + q.depth + r.depth;
    volume += area / 3 * sum;
    depth_squared += area / 6 *
                     (p.depth * p.depth + q.depth * q.depth + r.depth * r.depth + p.depth * q.depth +
                      q.depth * r.depth + r.depth * p.depth);
    base += area;
    const Vector<2> corners = p.foot + q.foot + r.foot;
    base_moment += area / 3 * corners;
    base_spread += area * (p.foot * p.foot.transpose() + q.foot * q.foot.transpose() +
                           r.foot * r.foot.transpose() + corners * corners.transpose());
    moment += area / 12 * (sum * corners + p.depth * p.foot + q.depth * q.foot + r.depth * r.foot);
    add_polar_moment(area, p, q, r);
    add_polar_moment(area, q, r, p);
    add_polar_moment(area, r, p, q);
  }

 private:
  /// Integral of the squared distance times the depth at p alone: products of three barycentric coordinates
  /// over a triangle, 2 area a! b! c! / 5!.
  void add_polar_moment(double area, const DepthPoint& p, const DepthPoint& q, const DepthPoint& r) {
    const Vector<2>&u = p.foot, &v = q.foot, &w = r.foot;
    polar_moment += p.depth * area / 60 *
                    (6 * u.squaredNorm() + 2 * v.squaredNorm() + 2 * w.squaredNorm() +
                     2 * (2 * u.dot(v) + v.dot(w) + 2 * w.dot(u)));
  }
};

/// Calls `visit(from, to)` for the pieces of a convex polygon of many corners, divided as a fan: each has the
/// first corner and those from `from` to `to`.
template <class Visitor>
void for_each_piece(int corners, Visitor visit) {
  constexpr int max_steps = 14;
  for (int from = 1; from < corners - 1; from += max_steps)
    visit(from, std::min(from + max_steps, corners - 1));
}

/// A convex polygon with depths, a piece of one face, cut by one half-plane after another.
class DepthPolygon {
 public:
  void add(const DepthPoint& p) {
    // Each cut by a side of another piece adds one corner at most; rounding may add a few without area.
    if (count_ < room) corner_[count_++] = p;
  }
  bool is_empty() const { return count_ < 3; }
  void clear() { count_ = 0; }

  /// Keeps the part of another polygon with height <= 0.
  template <class Height>
  void keep_below(const DepthPolygon& whole, Height height) {
    count_ = 0;
    if (!whole.is_empty()) clip(whole.corners(), height, 0, [&](const DepthPoint& p) { add(p); });
  }

  void add_to(DepthSums& sums, double sign) const {
    for (int i = 1; i + 1 < count_; ++i) sums.add(corner_[0], corner_[i], corner_[i + 1], sign);
  }

 private:
  std::span<const DepthPoint> corners() const { return {corner_, std::size_t(count_)}; }

  static constexpr int room = 48;
  int count_ = 0;
  DepthPoint corner_[room];
};

/// Can a part of one box lie over a part of another, along the normal?
bool may_cover(const Box<3>& over, const Box<3>& under) {
  return over.upper.z() > under.lower.z() && over.lower.x() < under.upper.x() &&
         under.lower.x() < over.upper.x() && over.lower.y() < under.upper.y() &&
         under.lower.y() < over.upper.y();
}

/// A block in coordinates of a plane: two on it, and the height. Those of the first vertices, and the boxes
/// of the first faces, are stored; for larger blocks the others are computed on demand.
class SeenBlock {
 public:
  SeenBlock(const PlaneFrame& plane, const Outline<3>& block, const Vector<3>& shift)
      : plane_(plane), block_(block), shift_(shift) {
    for (int v = 0; v < block.vertex_count(); ++v) {
      const Vector<3> p = make(v);
      if (v < most_kept) kept_[v] = p;
      box_.include(p);
    }
    for (int f = 0; f < std::min(block.face_count(), most_kept); ++f) {
      const Box<3> box = make_box(f);
      lower_[f] = box.lower;
      upper_[f] = box.upper;
    }
  }

  const Topology& topology() const { return *block_.topology; }
  Vector<3> vertex(int v) const { return v < most_kept ? kept_[v] : make(v); }
  const Box<3>& box() const { return box_; }
  Box<3> box_of(int face) const {
    return face < most_kept ? Box<3>{lower_[face], upper_[face]} : make_box(face);
  }
  /// Outer normal in these coordinates.
  Vector<3> normal(int face) const { return seen(block_.normal(face)); }
  double offset(int face, const Vector<3>& n) const {
    return n.dot(vertex(topology().face_vertex[topology().first_of_face[face]]));
  }

 private:
  Vector<3> make(int v) const { return seen(block_.vertex(v) + shift_ - plane_.origin); }

  Box<3> make_box(int face) const {
    const Topology& t = topology();
    Box<3> box;
    for (int k = t.first_of_face[face]; k < t.first_of_face[face + 1]; ++k)
      box.include(vertex(t.face_vertex[k]));
    return box;
  }

  Vector<3> seen(const Vector<3>& v) const {
    return {plane_.along.dot(v), plane_.across.dot(v), plane_.normal.dot(v)};
  }

  static constexpr int most_kept = 64;
  const PlaneFrame& plane_;
  const Outline<3>& block_;
  Vector<3> shift_;
  Vector<3> kept_[most_kept];
  Vector<3> lower_[most_kept];  // of the boxes; an array of Box would be initialized first
  Vector<3> upper_[most_kept];
  Box<3> box_;
};

/// A face in these coordinates: its corners, counter-clockwise even if it faces down, and its height.
class SeenFace {
 public:
  SeenFace(const SeenBlock& block, int face)
      : block_(block),
        first_(block.topology().first_of_face[face]),
        count_(block.topology().first_of_face[face + 1] - first_) {
    const Vector<3> normal = block.normal(face);
    constexpr double upright = 1e-9;  // the cosine: a steeper face covers less than rounding
    if (std::abs(normal.z()) <= upright) return;
    looks_ = normal.z() > 0 ? 1 : -1;
    slope_ = -normal.head<2>() / normal.z();
    at_origin_ = block.offset(face, normal) / normal.z();
  }

  double looks() const { return looks_; }  // 1 up, -1 down, 0 neither
  int count() const { return count_; }
  Vector<2> corner(int i) const {
    const int k = looks_ > 0 ? i : count_ - 1 - i;
    return block_.vertex(block_.topology().face_vertex[first_ + k]).head<2>();
  }
  double height(const Vector<2>& foot) const { return at_origin_ + slope_.dot(foot); }

 private:
  const SeenBlock& block_;
  int first_;
  int count_;
  double looks_ = 0;
  double at_origin_ = 0;
  Vector<2> slope_{0, 0};
};

/// Adds the depth of a face of b below one of a, where they overlap. On a line through both blocks, with the
/// upper and lower side of each, the length of the overlap is (upper a - lower b) - (upper a - upper b) -
/// (lower a - lower b) + (lower a - upper b), with negative terms set to 0. Half the same sum of squares is
/// its integral over the penetration. So the force is the energy's derivative.
void add_between(const SeenFace& of_a, const SeenFace& of_b, DepthSums& sums) {
  const double sign = -of_a.looks() * of_b.looks();
  const auto point = [&](const Vector<2>& foot) {
    return DepthPoint{foot, of_a.height(foot) - of_b.height(foot)};
  };
  DepthPolygon face, above, part[2];
  for_each_piece(of_a.count(), [&](int from, int to) {
    face.clear();
    face.add(point(of_a.corner(0)));
    for (int i = from; i <= to; ++i) face.add(point(of_a.corner(i)));
    above.keep_below(face, [](const DepthPoint& p) { return -p.depth; });
    if (above.is_empty()) return;
    for_each_piece(of_b.count(), [&](int begin, int end) {
      const DepthPolygon* left = &above;
      Vector<2> corner = of_b.corner(0);
      const auto cut_by_side_to = [&](const Vector<2>& next) {
        const HalfPlane side(std::exchange(corner, next), next, 0);
        DepthPolygon& kept = part[left == part];
        kept.keep_below(*left, [&](const DepthPoint& p) { return side.height(p.foot); });
        left = &kept;
      };
      for (int i = begin; i <= end; ++i) cut_by_side_to(of_b.corner(i));
      cut_by_side_to(of_b.corner(0));
      left->add_to(sums, sign);
    });
  });
}

}  // namespace

Overlap<3> measure_overlap(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                           const Vector<3>& normal, const Vector<3>& point) {
  const PlaneFrame plane(normal, point);
  const SeenBlock seen_a(plane, a, Vector<3>::Zero()), seen_b(plane, b, to_b);
  DepthSums sums;
  for (int i = 0; i < a.face_count(); ++i) {
    const Box<3> box = seen_a.box_of(i);
    if (!may_cover(box, seen_b.box())) continue;
    const SeenFace of_a(seen_a, i);
    if (of_a.looks() == 0) continue;
    for (int j = 0; j < b.face_count(); ++j) {
      if (!may_cover(box, seen_b.box_of(j))) continue;
      const SeenFace of_b(seen_b, j);
      if (of_b.looks() != 0) add_between(of_a, of_b, sums);
    }
  }
  Overlap<3> overlap;
  if (!(sums.volume > 0)) return overlap;
  const Vector<2> center = sums.moment / sums.volume;
  overlap.content = sums.volume;
  overlap.depth_squared = sums.depth_squared;
  overlap.base = std::max(sums.base, 0.0);
  overlap.center = plane.at(center);
  overlap.twist_radius = std::sqrt(std::max(sums.polar_moment / sums.volume - center.squaredNorm(), 0.0));
  if (!(sums.base > 0)) return overlap;
  const Vector<2> middle = sums.base_moment / sums.base;
  overlap.middle = plane.at(middle);
  overlap.spread = plane.in_space(sums.base_spread / (12 * sums.base) - middle * middle.transpose());
  return overlap;
}

}  // namespace halfspace
