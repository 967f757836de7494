#include "force/spring/point_springs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/angle.h"
#include "geometry/mean_distance.h"
#include "geometry/tolerances.h"

namespace halfspace {
namespace {

constexpr double square_corner = 0.25;

/// 0 where the direction is lost by rounding or overflow.
double part_of_whole_turn(double cosine, double sine) {
  return cosine * cosine + sine * sine > 0 ? quick_angle_at(cosine, sine) * (0.5 / std::numbers::pi) : 0;
}

/// The exterior angle between two directions, divided by 2 pi. A corner made concave by rounding counts as
/// straight, or as a reversal.
double part_of_turn(const Vector<3>& from, const Vector<3>& to, const Vector<3>& normal) {
  const Vector<3> across = cross_product(from, to);
  const double rise = across.dot(normal) > 0 ? across.norm() : 0;
  return part_of_whole_turn(from.dot(to), rise);
}

/// By the exterior angles of the corners in the plane of the other block's face, not in the contact plane.
void share_by_turns(const Contact<3>& contact, PointSprings<3>& springs) {
  const int count = contact.point_count;
  const auto next = [&](int i) { return i + 1 == count ? 0 : i + 1; };
  const auto side_after = [&](int i) {
    const int j = next(i);
    return Vector<3>((contact.points[j] - contact.points[i]) +
                     (contact.gaps[j] - contact.gaps[i]) * contact.normal);
  };
  Vector<3> before = Vector<3>::Zero();
  double length_before = 0;
  for (int i = count - 1; i >= 0 && length_before == 0; --i) {
    before = side_after(i);
    length_before = before.norm();
  }
  if (length_before > 0) before /= length_before;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    Vector<3> after = side_after(i);
    const double length = after.norm();
    springs.part[i] = 0;
    if (length == 0) continue;  // duplicate point: the next one has the angle of both
    after /= length;
    springs.part[i] = part_of_turn(before, after, contact.normal);
    sum += springs.part[i];
    before = after;
  }
  // A region smaller than rounding may have all corners in one point.
  for (int i = 0; i < count; ++i) springs.part[i] = sum > 0 ? springs.part[i] * (1 / sum) : 1.0 / count;
}

/// The block that touches the contact plane with a vertex, or with an edge from that vertex.
struct TouchingBlock {
  const Outline<3>& block;
  Vector<3> shift;
  Vector<3> inward;  // from the contact plane into the block
  int vertex;

  const Topology& topology() const { return *block.topology; }
  int first(int v) const { return topology().first_of_vertex[v]; }
  int end(int v) const { return topology().first_of_vertex[v + 1]; }
  int before(int v, int k) const { return k == first(v) ? end(v) - 1 : k - 1; }
  int after(int v, int k) const { return k + 1 == end(v) ? first(v) : k + 1; }
  Vector<3> direction(int v, int k) const {
    return (block.vertex(topology().vertex_neighbour[k]) - block.vertex(v)).normalized();
  }
  /// Cosine of the angle between the contact plane and the face after the vertex's k-th neighbour.
  double facing(int k) const { return -inward.dot(block.normal(topology().vertex_face[k])); }
  /// The exterior angle of the face's corner at the vertex, divided by 2 pi.
  double part_of_corner(int v, int k) const {
    const Vector<3> in = direction(v, k), out = direction(v, after(v, k));
    return part_of_whole_turn(-in.dot(out), cross_product(in, out).norm());
  }
};

double part_of_vertex(const TouchingBlock& touching) {
  int most = touching.first(touching.vertex);
  for (int k = most + 1; k < touching.end(touching.vertex); ++k)
    if (touching.facing(k) > touching.facing(most)) most = k;
  return touching.part_of_corner(touching.vertex, most);
}

/// The edge at the vertex along the region, and the one of its two faces more nearly parallel to the contact
/// plane. Where the region ends before the edge does, another edge crosses.
void share_edge(const TouchingBlock& touching, const Contact<3>& contact, PointSprings<3>& springs) {
  const Topology& topology = touching.topology();
  const int vertex = touching.vertex;
  const Vector<3> along = (contact.points[1] - contact.points[0]).normalized();
  int edge = touching.first(vertex);
  double most = -1;
  for (int k = edge; k < touching.end(vertex); ++k) {
    const double cosine = std::abs(touching.direction(vertex, k).dot(along));
    if (cosine > most) {
      most = cosine;
      edge = k;
    }
  }
  const int far = topology.vertex_neighbour[edge], before = touching.before(vertex, edge);
  const int corner = touching.facing(before) > touching.facing(edge) ? before : edge;
  int far_corner = touching.first(far);
  while (topology.vertex_face[far_corner] != topology.vertex_face[corner]) ++far_corner;
  const double length = (touching.block.vertex(far) - touching.block.vertex(vertex)).norm();
  const auto is_at = [&](const Vector<3>& point, int v) {
    return std::abs(along.dot(point - touching.shift - touching.block.vertex(v))) <= end_reach * length;
  };
  for (int i = 0; i < 2; ++i) {
    springs.part[i] = is_at(contact.points[i], vertex) ? touching.part_of_corner(vertex, corner)
                      : is_at(contact.points[i], far)  ? touching.part_of_corner(far, far_corner)
                                                       : square_corner;
  }
}

}  // namespace

PointSprings<3> point_springs(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                              const Contact<3>& contact) {
  PointSprings<3> springs;
  if (contact.point_count > 2) {
    share_by_turns(contact, springs);
  } else if (contact.pair.kind == PotentialPair<3>::edge_edge) {
    springs.part[0] = springs.part[1] = square_corner;
  } else {
    const TouchingBlock touching = contact.pair.kind == PotentialPair<3>::face_vertex
                                       ? TouchingBlock{b, to_b, contact.normal, contact.pair.b}
                                       : TouchingBlock{a, Vector<3>::Zero(), -contact.normal, contact.pair.a};
    if (contact.point_count == 2)
      share_edge(touching, contact, springs);
    else
      springs.part[0] = part_of_vertex(touching);
  }
  return springs;
}

/// The gap is linear over the region, so the overlap ends at a straight line. The sums are those of the
/// region's projection along the axis nearest to the normal.
LoadedPart loaded_part(const Contact<3>& contact, bool bonded) {
  const int count = contact.point_count;
  const auto carries = [&](int i) { return bonded || contact.gaps[i] <= 0; };
  const auto part_to_end = [&](int i, int j) {
    return contact.gaps[i] / (contact.gaps[i] - contact.gaps[j]);
  };
  if (count == 1) return {contact.center, 0};
  if (count == 2) {
    Vector<3> first = contact.points[0], second = contact.points[1];
    if (carries(0) != carries(1))
      (carries(0) ? second : first) = first + part_to_end(0, 1) * (second - first);
    return {0.5 * (first + second), (second - first).norm() / 4};
  }
  int z = 0;
  contact.normal.cwiseAbs().maxCoeff(&z);
  int x = (z + 1) % 3, y = (z + 2) % 3;
  if (contact.normal[z] < 0) std::swap(x, y);  // counter-clockwise, as about the normal
  const auto seen = [&](int i) { return Vector<2>(contact.points[i][x], contact.points[i][y]); };
  Vector<2> corners[2 * max_region_points];
  int kept = 0;
  for (int i = 0, before = count - 1; i < count; before = i++) {
    if (carries(before) != carries(i))
      corners[kept++] = seen(before) + part_to_end(before, i) * (seen(i) - seen(before));
    if (carries(i)) corners[kept++] = seen(i);
  }
  double area = 0, xx = 0, xy = 0, yy = 0;
  Vector<2> sum(0, 0);
  for (int i = 1; i + 1 < kept; ++i) {
    const Vector<2> p = corners[i] - corners[0], q = corners[i + 1] - corners[0], r = p + q;
    const double part = cross(p, q);
    area += part;
    sum += part * r;
    xx += part * (p.x() * p.x() + q.x() * q.x() + r.x() * r.x());
    xy += part * (p.x() * p.y() + q.x() * q.y() + r.x() * r.y());
    yy += part * (p.y() * p.y() + q.y() * q.y() + r.y() * r.y());
  }
  if (!(area > 0)) return {contact.center, 0};
  const double share = 1 / (12 * area), steepness = 1 / contact.normal[z];
  const Vector<2> mean = 4 * share * sum, slope(steepness * contact.normal[x], steepness * contact.normal[y]);
  xx = share * xx - mean.x() * mean.x();
  xy = share * xy - mean.x() * mean.y();
  yy = share * yy - mean.y() * mean.y();
  const double zz = slope.x() * slope.x() * xx + 2 * slope.x() * slope.y() * xy + slope.y() * slope.y() * yy;
  LoadedPart part;
  part.middle[x] = corners[0].x() + mean.x();
  part.middle[y] = corners[0].y() + mean.y();
  part.middle[z] = contact.center[z] - slope.dot(Vector<2>(part.middle[x] - contact.center[x],
                                                           part.middle[y] - contact.center[y]));
  part.mean_distance = mean_distance(xx + yy + zz, (xx * yy - xy * xy) * (1 + slope.squaredNorm()));
  return part;
}

}  // namespace halfspace
