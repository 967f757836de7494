#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"
#include "narrow_phase/space/contact_plane.h"
#include "narrow_phase/space/face_overlap.h"
#include "narrow_phase/space/manifold_edges.h"
#include "narrow_phase/space/pair.h"
#include "narrow_phase/space/potential_pairs.h"
#include "narrow_phase/space/separation.h"
#include "world/hard_contact/manifold.h"

namespace halfspace {
namespace {

/// Two blocks in the frame of the first.
struct PairInFrame {
  PairInFrame(const PosedBlock<3>& a, const PosedBlock<3>& b)
      : turn(a.rotation.inverse() * b.rotation), to_b(a.rotation.inverse() * (b.position - a.position)) {}
  Rotation<3> turn;
  Vector<3> to_b;
};

/// The largest separation, or one above the margin.
Separation<3> largest_separation(const PosedBlock<3>& a, const PosedBlock<3>& b, const PairInFrame& frame,
                                 double margin) {
  if (by_all_combinations(a.own, b.own)) {
    const TurnedPolyhedron turned(b.own, frame.turn);
    return find_separation_by_all(a.own, turned.outline(), frame.to_b, margin);
  }
  const Separation<3> found =
      find_separation_by_descent(MinkowskiDifference<Rotation<3>>(a.own, b.own, frame.to_b, frame.turn));
  if (found.gap > margin) return found;
  const SeenOutline seen_a(a.own), seen_b(b.own, frame.turn);
  PotentialPair<3> pair =
      descend(seen_a, seen_b, frame.to_b,
              initial_pair(seen_a, seen_b, frame.to_b, {PairCache<3>::separated, found.pair, found.normal}));
  const double gap = refresh(seen_a, seen_b, frame.to_b, pair);
  return {gap, pair, normal_of(seen_a, seen_b, pair)};
}

/// The gap of a pair of features, with the vertex of a face brought up to date.
double gap_of_pair(const PosedBlock<3>& a, const PosedBlock<3>& b, const PairInFrame& frame,
                   PotentialPair<3>& pair) {
  return refresh(SeenOutline(a.own), SeenOutline(b.own, frame.turn), frame.to_b, pair);
}

/// One block as the owner of a face, the other seen in its frame.
struct FaceFrame {
  SeenOutline owner;
  SeenOutline other;
  Rotation<3> turn;
  Vector<3> to_other;
  int face;
  int vertex;  // the support of the other

  Vector<3> normal() const { return owner.normal(face); }
  Vector<3> support() const { return other.vertex(vertex) + to_other; }
  double gap(const Vector<3>& place) const { return normal().dot(place) - owner.offset[face]; }
  Vector<3> in_other(const Vector<3>& place) const { return turn.inverse() * (place - to_other); }
};

/// The face at the support vertex that faces the plane most directly.
int facing_face(const FaceFrame& f) { return face_along(f.other, f.vertex, -f.normal()); }

/// Is a point of its plane inside a face by more than `flush`?
bool is_well_over(const FlatFace& face, const Vector<2>& point, double flush) {
  for (int i = 0; i < face.count(); ++i) {
    const HalfPlane side(face.corner(i), face.corner(face.next(i)), 0);
    if (side.height(point) > -flush * side.outward.norm()) return false;
  }
  return true;
}

/// Corners of the common part of the face and the facing one, on the latter.
bool clip_faces(const FaceFrame& f, double flush, Manifold<3>& manifold) {
  const int facing = facing_face(f);
  const Vector<3> normal = f.normal(), facing_normal = f.other.normal(facing);
  if (cross_product(normal, facing_normal).norm() > facing_sine || normal.dot(facing_normal) >= 0)
    return false;
  const Vector<3> support = f.support();
  const double gap = f.gap(support);
  const PlaneFrame plane(normal, support - gap * normal);
  const Vector<2> slope = plane.in_plane(facing_normal) / -normal.dot(facing_normal);
  const FaceOverlap overlap = overlap_of(FlatFace(plane, f.other, facing, f.to_other),
                                         FlatFace(plane, f.owner, f.face, Vector<3>::Zero()), slope, flush);
  if (!(overlap.area > flush * std::sqrt(overlap.area))) return false;
  manifold.count = overlap.count;
  manifold.area = overlap.area;
  for (int i = 0; i < overlap.count; ++i) {
    const double height = gap + slope.dot(overlap.corner[i]);
    manifold.point[std::size_t(i)] = f.in_other(plane.at(overlap.corner[i]) + height * normal);
  }
  return true;
}

/// The ends of the part of an edge in front of the face.
bool clip_edge(const FaceFrame& f, double flush, Manifold<3>& manifold) {
  const Topology& topology = *f.other.topology;
  const Vector<3> normal = f.normal(), start = f.other.vertex(f.vertex);
  int far_vertex = -1;
  double least = facing_sine;
  for (int k = topology.first_of_vertex[f.vertex]; k < topology.first_of_vertex[f.vertex + 1]; ++k) {
    const Vector<3> along = f.other.vertex(topology.vertex_neighbour[k]) - start;
    const double sine = std::abs(normal.dot(along)) / along.norm();
    if (sine >= least) continue;
    least = sine;
    far_vertex = topology.vertex_neighbour[k];
  }
  if (far_vertex < 0) return false;
  const PlaneFrame plane(normal, f.support() - f.gap(f.support()) * normal);
  const Vector<3> along = f.other.vertex(far_vertex) - start;
  const FlatFace face(plane, f.owner, f.face, Vector<3>::Zero());
  const SegmentPart part = part_over(face, Vector<2>::Zero(), plane.in_plane(along), flush);
  if (part.from >= part.to) return false;
  const Vector<2> middle = 0.5 * (part.from + part.to) * plane.in_plane(along);
  if (!is_well_over(face, middle, flush)) return false;
  manifold.count = 2;
  manifold.point[0] = f.turn.inverse() * Vector<3>(start + part.from * along);
  manifold.point[1] = f.turn.inverse() * Vector<3>(start + part.to * along);
  return true;
}

/// Is the support vertex in front of the face?
bool is_over_face(const FaceFrame& f, double flush) {
  const PlaneFrame plane(f.normal(), f.support());
  return is_well_over(FlatFace(plane, f.owner, f.face, Vector<3>::Zero()), Vector<2>::Zero(), flush);
}

/// The points in front of a face. None where the other block lies beside it and does not overlap it.
void clip(const FaceFrame& f, double flush, bool overlaps, Manifold<3>& manifold) {
  manifold.count = 0;
  manifold.area = 0;
  if (clip_faces(f, flush, manifold) || clip_edge(f, flush, manifold)) return;
  if (!overlaps && !is_over_face(f, flush)) return;
  manifold.count = 1;
  manifold.point[0] = f.turn.inverse() * f.other.vertex(f.vertex);
}

/// The nearest point of b's edge to that of a. Nearly parallel edges have no normal that holds while they
/// turn.
bool meet_at_edges(const PosedBlock<3>& a, const PosedBlock<3>& b, const PairInFrame& frame,
                   const PotentialPair<3>& pair, Manifold<3>& manifold) {
  const SeenOutline seen_b(b.own, frame.turn);
  const MeetingEdges edges(SeenOutline(a.own), seen_b, pair);
  const double squares = edges.a.along.squaredNorm() * edges.b.along.squaredNorm();
  if (edges.parallelogram.square <= nearly_flush * nearly_flush * squares) return false;
  const NearestPoints nearest(edges, frame.to_b);
  if (!nearest.are_on_edges()) return false;
  manifold.plane = ManifoldPlane::edges;
  manifold.area = 0;
  manifold.feature = pair.a;
  manifold.other_feature = pair.b;
  manifold.count = 1;
  manifold.point[0] = frame.turn.inverse() * Vector<3>(edges.b.start + nearest.share_of_b * edges.b.along);
  return true;
}

/// The pair that a manifold's plane belongs to.
PotentialPair<3> pair_of(const Manifold<3>& manifold) {
  switch (manifold.plane) {
    case ManifoldPlane::face_of_a:
      return {PotentialPair<3>::face_vertex, manifold.feature, 0};
    case ManifoldPlane::face_of_b:
      return {PotentialPair<3>::vertex_face, 0, manifold.feature};
    default:
      return {PotentialPair<3>::edge_edge, manifold.feature, manifold.other_feature};
  }
}

}  // namespace

bool find_manifold(const PosedBlock<3>& a, const PosedBlock<3>& b, double margin, Manifold<3>& manifold) {
  const PairInFrame frame(a, b);
  const double size = std::min(a.own.offset[0], b.own.offset[0]), equal = face_reach * size;
  PotentialPair<3> known = pair_of(manifold);
  const double known_gap =
      known.kind == PotentialPair<3>::edge_edge ? -HUGE_VAL : gap_of_pair(a, b, frame, known);
  if (known_gap > margin) return false;
  Separation<3> best = largest_separation(a, b, frame, margin);
  const bool is_between_edges = best.pair.kind == PotentialPair<3>::edge_edge;
  const PotentialPair<3> edges = best.pair;
  if (known_gap >= best.gap - (is_between_edges ? nearly_flush * size : equal)) {
    best.gap = known_gap;
    best.pair = known;
  }
  if (best.gap > margin || best.pair.kind == PotentialPair<3>::vertex_vertex) return false;
  if (best.pair.kind == PotentialPair<3>::edge_edge) {
    const SeenOutline seen_a(a.own), seen_b(b.own, frame.turn);
    PotentialPair<3> face = FacesAtEdges(seen_a, seen_b, best.pair).shallowest(seen_a, seen_b, frame.to_b);
    const double face_gap = refresh(seen_a, seen_b, frame.to_b, face);
    const bool is_as_far = face_gap >= best.gap - nearly_flush * size;
    if (!is_as_far && meet_at_edges(a, b, frame, edges, manifold)) return true;
    best.gap = face_gap;
    best.pair = face;
  }
  const double flush = touch_reach * size;
  const bool overlaps = best.gap < -flush;
  if (best.pair.kind == PotentialPair<3>::face_vertex) {
    manifold.plane = ManifoldPlane::face_of_a;
    manifold.feature = best.pair.a;
    clip({SeenOutline(a.own), SeenOutline(b.own, frame.turn), frame.turn, frame.to_b, best.pair.a,
          best.pair.b},
         flush, overlaps, manifold);
  } else {
    const PairInFrame seen_from_b(b, a);
    manifold.plane = ManifoldPlane::face_of_b;
    manifold.feature = best.pair.b;
    clip({SeenOutline(b.own), SeenOutline(a.own, seen_from_b.turn), seen_from_b.turn, seen_from_b.to_b,
          best.pair.b, best.pair.a},
         flush, overlaps, manifold);
  }
  return manifold.count > 0 || (is_between_edges && meet_at_edges(a, b, frame, edges, manifold));
}

Vector<3> normal_of(const Manifold<3>& manifold, const PosedBlock<3>& a, const PosedBlock<3>& b) {
  if (manifold.plane == ManifoldPlane::face_of_a) return a.rotation * a.own.normal(manifold.feature);
  if (manifold.plane == ManifoldPlane::face_of_b) return -(b.rotation * b.own.normal(manifold.feature));
  return edge_pair_normal(SeenOutline(a.own, a.rotation), manifold.feature, SeenOutline(b.own, b.rotation),
                          manifold.other_feature);
}

}  // namespace halfspace
