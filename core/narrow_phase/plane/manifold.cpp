#include <algorithm>
#include <cmath>

#include "narrow_phase/pair.h"
#include "narrow_phase/plane/potential_pairs.h"

// The contact region of two polygons at a potential pair, an edge and a vertex in front of it:
//
//   the other block's edge at the vertex is nearly parallel, and lies over the edge: edge on edge, two points
//   (beyond the parallel angle: while both points overlap). The plane is that of the edge of smaller depth
//
//   else the foot of the vertex is on the edge: vertex on edge, one point
//
//   else, near an end of the edge: vertex on vertex, along the sum of both half-spaces' normals
//
//   else the neighbouring pair beyond that end, from the start

namespace halfspace {
namespace {

/// A potential pair in the frame of the edge's owner.
struct PairFrame {
  const Outline<2>& owner;
  const Outline<2>& other;
  Vector<2> to_other;
  int edge;
  int vertex;
  Vector<2> normal = owner.normal(edge);
  Vector<2> tangent = perpendicular(normal);  // along the edge, counter-clockwise around the owner
  Vector<2> start = owner.vertex(edge);
  Vector<2> end = owner.vertex(owner.next(edge));
  Vector<2> middle = 0.5 * (start + end);
  double half_length = 0.5 * tangent.dot(end - start);

  /// Distance along the edge from its midpoint, so that a mirrored pair has the same bits, mirrored.
  double along(const Vector<2>& p) const { return tangent.dot(p - middle); }
  double gap(const Vector<2>& p) const { return normal.dot(p) - owner.offset[edge]; }
  Vector<2> on_edge(double s) const { return middle + s * tangent; }
  Vector<2> other_vertex(int v) const { return other.vertex(v) + to_other; }
};

PairFrame frame_of(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                   const PotentialPair<2>& pair) {
  const Owner owner(a, b, pair);
  return {owner.block, owner.other, owner.sign * to_b, pair.edge, pair.vertex};
}

/// The other block's edge at the vertex that is more nearly parallel to the contact plane.
struct FacingEdge {
  int edge;
  int far_vertex;
  double sine;  // of the angle to the contact plane, >= 0 to rounding
};

FacingEdge facing_edge(const PairFrame& f) {
  const int before = f.other.previous(f.vertex);
  const double cosine_after = -f.other.normal(f.vertex).dot(f.normal);
  const double cosine_before = -f.other.normal(before).dot(f.normal);
  // By tables instead of branches, as the edge is unpredictable.
  const int ends[] = {before, f.other.next(f.vertex)}, edges[] = {before, f.vertex};
  const int after = cosine_after >= cosine_before;
  const double sine = std::abs(cross(f.other.normal(edges[after]), f.normal));
  return {edges[after], ends[after], std::max(cosine_after, cosine_before) > 0 ? sine : 1};
}

/// The ends of the facing edge, the vertex and the far one: distances along the edge from its midpoint, and
/// gaps.
struct FacingPlaces {
  double near;
  double far;
  double gap;
  double gap_of_far;
};

/// The facing edge is the deeper one unless the vertex is beyond the edge's end, or nearly there.
bool may_turn(const PairFrame& f, const FacingEdge& facing, const FacingPlaces& at) {
  const double inside = f.half_length + (at.far > at.near ? at.near : -at.near);
  return inside < std::abs(at.gap) * facing.sine;
}

/// Turns the pair to the facing edge if that has the smaller depth, so that the plane does not depend on the
/// edge through which the blocks met.
[[gnu::noinline]] bool turn_to_facing(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                                      int edge, PotentialPair<2>& pair) {
  PotentialPair<2> own = pair, other{1 - pair.owner, edge, pair.edge};
  if (!(refresh(a, b, to_b, other) > refresh(a, b, to_b, own))) return false;
  pair = other;
  return true;
}

void describe_edge_edge(const PairFrame& f, const FacingPlaces& at, double from, double to,
                        Contact<2>& contact) {
  contact.type = ContactType::edge_edge;
  contact.length = to - from;
  contact.point_count = 2;
  const double slope = (at.gap_of_far - at.gap) / (at.far - at.near);
  const double ends[2] = {from, to};
  for (int i = 0; i < 2; ++i) {
    contact.points[i] = f.on_edge(ends[i]);
    contact.gaps[i] = at.gap + slope * (ends[i] - at.near);
  }
  // The vertex itself may lie beyond the edge's end: the gap is that of the deeper end of the region.
  contact.gap = std::min(contact.gaps[0], contact.gaps[1]);
}

void describe_point(ContactType type, const Vector<2>& point, Contact<2>& contact) {
  contact.type = type;
  contact.length = 0;
  contact.point_count = 1;
  contact.points[0] = point;
  contact.gaps[0] = contact.gap;
  contact.gaps[1] = 0;
  contact.points[1].setZero();
}

/// Two vertices meet: the normal is that of the sum of both half-spaces' normals (section 2.5).
void describe_vertex_vertex(const PairFrame& f, const Vector<2>& end, const Vector<2>& adjacent_normal,
                            Contact<2>& contact) {
  const Vector<2> vertex = f.other_vertex(f.vertex);
  contact.normal = (f.normal + adjacent_normal).normalized();
  contact.gap = contact.normal.dot(vertex - end);
  describe_point(ContactType::vertex_vertex, end, contact);
}

/// Outer normal of a pair's half-space, from the owner of the pair's frame `f` to the other block.
Vector<2> normal_away_from(const PotentialPair<2>& pair, int frame_owner, const Outline<2>& a,
                           const Outline<2>& b) {
  const Vector<2> normal = pair.owner == 0 ? a.normal(pair.edge) : b.normal(pair.edge);
  return pair.owner == frame_owner ? normal : Vector<2>(-normal);
}

}  // namespace

void describe_contact(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, PotentialPair<2>& pair,
                      const DetectOptions& options, Contact<2>& contact) {
  for (int steps = a.count + b.count; steps >= 0; --steps) {
    const PairFrame f = frame_of(a, b, to_b, pair);
    const Vector<2> vertex = f.other_vertex(f.vertex);
    const double s = f.along(vertex);
    contact.normal = f.normal;

    const FacingEdge facing = facing_edge(f);
    contact.gap = f.gap(vertex);
    if (facing.sine < options.region_angle()) {
      const Vector<2> far = f.other_vertex(facing.far_vertex);
      const FacingPlaces at = {s, f.along(far), contact.gap, f.gap(far)};
      const double from = std::max(-f.half_length, std::min(at.near, at.far));
      const double to = std::min(f.half_length, std::max(at.near, at.far));
      if (from < to) {
        describe_edge_edge(f, at, from, to, contact);
        const bool both_overlap = std::max(contact.gaps[0], contact.gaps[1]) < 0;
        if (facing.sine < options.parallel_angle ||
            (both_overlap && options.outlasts(contact.length, -contact.gap))) {
          if (steps > 0 && may_turn(f, facing, at) && turn_to_facing(a, b, to_b, facing.edge, pair)) continue;
          break;
        }
        contact.gap = at.gap;
      }
    }
    // The zone is a fraction of the shorter edge: for a long plate it would otherwise exceed small grains.
    const double facing_length = (f.other.vertex(facing.far_vertex) - f.other.vertex(f.vertex)).norm();
    const double zone = options.vertex_zone * std::min(2 * f.half_length, facing_length);
    if (std::abs(s) < f.half_length - zone) {
      describe_point(ContactType::vertex_edge, f.on_edge(s), contact);
      break;
    }
    const PotentialPair<2> adjacent = s < 0 ? previous_pair(a, b, pair) : next_pair(a, b, pair);
    const bool beyond = std::abs(s) > f.half_length + zone;
    if (beyond && steps > 0) {
      pair = adjacent;
      continue;
    }
    const Vector<2>& end = s < 0 ? f.start : f.end;
    describe_vertex_vertex(f, end, normal_away_from(adjacent, pair.owner, a, b), contact);
    break;
  }
  contact.pair = pair;
  contact.reserved = 0;
  // From the owner's frame to: relative to a's centroid, and from a to b.
  const double sign = 1 - 2 * pair.owner;
  contact.normal *= sign;
  for (int i = 0; i < contact.point_count; ++i) contact.points[i] += double(pair.owner) * to_b;
}

}  // namespace halfspace
