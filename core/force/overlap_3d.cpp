#include <algorithm>
#include <cmath>
#include <utility>

#include "detect/potential_pairs_3d.h"
#include "detect/region_3d_plane.h"
#include "force/overlap.h"

namespace halfspace {
namespace {

/// A point of a block's surface over the contact plane, and how deep it lies behind it.
struct DepthPoint {
  Vector<2> foot;
  double depth;
};

/// What is summed over triangles on which the depth is linear. Faces that look away from the plane take off
/// what those that face it have put under them too much: their triangles run the other way round.
struct DepthSums {
  double volume = 0;
  double depth_squared = 0;
  double base = 0;
  Vector<2> moment{0, 0};
  double polar_moment = 0;

  void add(const DepthPoint& p, const DepthPoint& q, const DepthPoint& r) {
    const double area = 0.5 * cross(q.foot - p.foot, r.foot - p.foot);
    const double sum = p.depth + q.depth + r.depth;
    volume += area / 3 * sum;
    depth_squared += area / 6 *
                     (p.depth * p.depth + q.depth * q.depth + r.depth * r.depth + p.depth * q.depth +
                      q.depth * r.depth + r.depth * p.depth);
    base += area;
    const Vector<2> corners = p.foot + q.foot + r.foot;
    moment += area / 12 * (sum * corners + p.depth * p.foot + q.depth * q.foot + r.depth * r.foot);
    add_polar_moment(area, p, q, r);
    add_polar_moment(area, q, r, p);
    add_polar_moment(area, r, p, q);
  }

 private:
  /// Integral of the squared distance times the depth at p alone: of the products of three barycentric
  /// coordinates over a triangle, 2 area a! b! c! / 5!.
  void add_polar_moment(double area, const DepthPoint& p, const DepthPoint& q, const DepthPoint& r) {
    const Vector<2>&u = p.foot, &v = q.foot, &w = r.foot;
    polar_moment += p.depth * area / 60 *
                    (6 * u.squaredNorm() + 2 * v.squaredNorm() + 2 * w.squaredNorm() +
                     2 * (2 * u.dot(v) + v.dot(w) + 2 * w.dot(u)));
  }
};

Overlap<3> overlap_of(const DepthSums& sums, const PlaneFrame& plane) {
  Overlap<3> overlap;
  if (!(sums.volume > 0)) return overlap;
  const Vector<2> center = sums.moment / sums.volume;
  overlap.content = sums.volume;
  overlap.depth_squared = sums.depth_squared;
  overlap.base = std::max(sums.base, 0.0);
  overlap.center = plane.at(center);
  overlap.twist_radius = std::sqrt(std::max(sums.polar_moment / sums.volume - center.squaredNorm(), 0.0));
  return overlap;
}

/// Calls `visit(from, to)` for the pieces of a fan that a convex polygon of many corners is cut into: each
/// has the first corner and those from `from` to `to`.
template <class Visitor>
void for_each_piece(int corners, Visitor visit) {
  constexpr int most_steps = 14;
  for (int from = 1; from < corners - 1; from += most_steps)
    visit(from, std::min(from + most_steps, corners - 1));
}

/// A convex polygon with depths, one piece of a face, that is cut by one half-plane after another.
class DepthPolygon {
 public:
  void add(const DepthPoint& p) {
    // Each cut by a side of another piece adds one corner at most; rounding may add a few of no area.
    if (count_ < room) corner_[count_++] = p;
  }
  bool is_empty() const { return count_ < 3; }

  /// Keeps what has a height of at most 0.
  template <class Height>
  void cut(Height height) {
    DepthPolygon kept;
    for (int i = 0; i < count_; ++i) {
      const DepthPoint &p = corner_[i], &q = corner_[i + 1 == count_ ? 0 : i + 1];
      const double at_p = height(p), at_q = height(q);
      if (at_p <= 0) kept.add(p);
      if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
        const double share = at_p / (at_p - at_q);
        kept.add({p.foot + share * (q.foot - p.foot), p.depth + share * (q.depth - p.depth)});
      }
    }
    *this = kept;
  }

  void add_to(DepthSums& sums) const {
    for (int i = 1; i + 1 < count_; ++i) sums.add(corner_[0], corner_[i], corner_[i + 1]);
  }

 private:
  static constexpr int room = 48;
  int count_ = 0;
  DepthPoint corner_[room];
};

/// Depth of the other block behind a face, seen from the block that owns the face.
class FaceDepth {
 public:
  FaceDepth(const Outline<3>& owner, int face, const Outline<3>& other, const Vector<3>& to_other)
      : owner_(owner),
        face_(face),
        other_(other),
        to_other_(to_other),
        plane_(owner.normal(face),
               owner.vertex(owner.topology->face_vertex[owner.topology->first_of_face[face]])),
        polygon_(plane_, owner, face, Vector<3>::Zero()) {}

  Overlap<3> measure() const {
    DepthSums sums;
    for (int f = 0; f < other_.face_count(); ++f) {
      if (reaches_behind(f)) add_face(f, sums);
    }
    // Faces that face the plane are seen from behind: clockwise.
    sums.volume = -sums.volume;
    sums.depth_squared = -sums.depth_squared;
    sums.base = -sums.base;
    sums.moment = -sums.moment;
    sums.polar_moment = -sums.polar_moment;
    return overlap_of(sums, plane_);
  }

 private:
  DepthPoint at(int vertex) const {
    const Vector<3> p = other_.vertex(vertex) + to_other_;
    return {plane_.foot_of(p), owner_.offset[face_] - plane_.normal.dot(p)};
  }

  bool reaches_behind(int f) const {
    const Topology& t = *other_.topology;
    return std::any_of(t.face_vertex + t.first_of_face[f], t.face_vertex + t.first_of_face[f + 1],
                       [&](int v) { return at(v).depth > 0; });
  }

  /// Pieces of the face, each cut by the plane and by the sides of each piece of the owner's face.
  void add_face(int f, DepthSums& sums) const {
    const Topology& t = *other_.topology;
    const int first = t.first_of_face[f];
    for_each_piece(t.first_of_face[f + 1] - first, [&](int from, int to) {
      DepthPolygon behind;
      behind.add(at(t.face_vertex[first]));
      for (int i = from; i <= to; ++i) behind.add(at(t.face_vertex[first + i]));
      behind.cut([](const DepthPoint& p) { return -p.depth; });
      if (!behind.is_empty())
        for_each_piece(polygon_.count(), [&](int begin, int end) { add_part(behind, begin, end, sums); });
    });
  }

  void add_part(DepthPolygon part, int begin, int end, DepthSums& sums) const {
    Vector<2> corner = polygon_.corner(0);
    const auto cut_by_side_to = [&](const Vector<2>& next) {
      const HalfPlane side(std::exchange(corner, next), next, 0);
      part.cut([&](const DepthPoint& p) { return side.height(p.foot); });
    };
    for (int i = begin; i <= end; ++i) cut_by_side_to(polygon_.corner(i));
    cut_by_side_to(polygon_.corner(0));
    part.add_to(sums);
  }

  const Outline<3>& owner_;
  int face_;
  const Outline<3>& other_;
  Vector<3> to_other_;
  PlaneFrame plane_;
  FlatFace polygon_;
};

/// How far the other edge's direction runs through a wedge before its surface is reached, both ways from the
/// point where it is `depth` deep along `normal`, and no farther than the edge itself.
struct Chord {
  double ahead;
  double back;
};

Chord chord_through(const Outline<3>& wedge, int edge, const Vector<3>& outward, double depth,
                    const Vector<3>& along, double to_end, double to_start) {
  Chord chord{to_end, to_start};
  for (const int face : {wedge.topology->edge_left[edge], wedge.topology->edge_right[edge]}) {
    const Vector<3> normal = wedge.normal(face);
    const double climb = normal.dot(along), height = depth * normal.dot(outward);
    if (climb > 0) chord.ahead = std::min(chord.ahead, height / climb);
    if (climb < 0) chord.back = std::min(chord.back, height / -climb);
  }
  return chord;
}

/// Of two edges: from the crossing, where it is deepest, the depth falls to nothing along each edge either
/// way, and linearly between.
Overlap<3> between_edges(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                         const PotentialPair<3>& pair) {
  const Vector<3> normal = edge_pair_normal(a, pair.a, b, pair.b);
  const Vector<3> start_a = a.vertex(a.topology->edge_start[pair.a]);
  const Vector<3> start_b = b.vertex(b.topology->edge_start[pair.b]) + to_b;
  const Vector<3> edge_a = edge_vector(a, pair.a), edge_b = edge_vector(b, pair.b);
  const double depth = normal.dot(start_a - start_b);
  const Vector<3> across = cross_product(edge_a, edge_b);
  const double squared = across.squaredNorm();
  if (!(depth > 0) || squared == 0) return {};
  const double s = std::clamp(cross_product(start_b - start_a, edge_b).dot(across) / squared, 0.0, 1.0);
  const double t = std::clamp(cross_product(start_b - start_a, edge_a).dot(across) / squared, 0.0, 1.0);
  const double length_a = edge_a.norm(), length_b = edge_b.norm();
  const Vector<3> along_a = edge_a / length_a, along_b = edge_b / length_b;
  const Chord of_a = chord_through(b, pair.b, -normal, depth, along_a, (1 - s) * length_a, s * length_a);
  const Chord of_b = chord_through(a, pair.a, normal, depth, along_b, (1 - t) * length_b, t * length_b);

  const Vector<3> middle = start_a + s * edge_a - 0.5 * depth * normal;
  const PlaneFrame plane(normal, middle);
  const DepthPoint peak{{0, 0}, depth};
  DepthPoint rim[] = {{plane.in_plane(of_a.ahead * along_a), 0},
                      {plane.in_plane(of_b.ahead * along_b), 0},
                      {plane.in_plane(-of_a.back * along_a), 0},
                      {plane.in_plane(-of_b.back * along_b), 0}};
  if (cross(rim[0].foot, rim[1].foot) < 0 || cross(rim[1].foot, rim[2].foot) < 0) std::swap(rim[1], rim[3]);
  DepthSums sums;
  for (int i = 0; i < 4; ++i) sums.add(peak, rim[i], rim[(i + 1) % 4]);
  return overlap_of(sums, plane);
}

}  // namespace

Overlap<3> measure_overlap(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                           const PotentialPair<3>& pair) {
  switch (pair.kind) {
    case PotentialPair<3>::face_vertex:
      return FaceDepth(a, pair.a, b, to_b).measure();
    case PotentialPair<3>::vertex_face: {
      Overlap<3> overlap = FaceDepth(b, pair.b, a, -to_b).measure();
      overlap.center += to_b;
      return overlap;
    }
    default:
      return between_edges(a, b, to_b, pair);
  }
}

}  // namespace halfspace
