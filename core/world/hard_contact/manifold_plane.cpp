#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"
#include "narrow_phase/plane/separation.h"
#include "world/hard_contact/manifold.h"

namespace halfspace {
namespace {

/// One block as the owner of faces, the other seen in its frame.
struct OwnerFrame {
  OwnerFrame(const PosedBlock<2>& block, const PosedBlock<2>& beside)
      : owner(block.own),
        other(beside.own),
        turn(block.rotation.inverse() * beside.rotation),
        to_other(block.rotation.inverse() * (beside.position - block.position)) {}

  Vector<2> normal_seen_from_other(int face) const { return turn.inverse() * owner.normal(face); }
  /// The other block's vertex nearest to the plane of a face or deepest behind it.
  int support(int face) const { return deepest_vertex(other, normal_seen_from_other(face)); }
  Vector<2> other_vertex(int i) const { return to_other + turn * other.vertex(i); }
  double gap(int face, const Vector<2>& place) const {
    return owner.normal(face).dot(place) - owner.offset[face];
  }
  double separation(int face) const { return gap(face, other_vertex(support(face))); }

  Outline<2> owner;
  Outline<2> other;
  Rotation<2> turn;
  Vector<2> to_other;
};

/// The face of largest separation of both blocks.
struct FaceOfLargestSeparation {
  int owner;
  int face;
  double separation;

  void try_all(const OwnerFrame& frame, int which, double margin, double equal) {
    for (int i = 0; i < frame.owner.face_count() && separation <= margin; ++i) {
      const double other = frame.separation(i);
      if (other > separation + equal) *this = {which, i, other};
    }
  }
};

/// The edge of the other block that faces a face most directly, of the two at the support vertex.
int facing_edge(const OwnerFrame& frame, int face) {
  const Vector<2> normal = frame.normal_seen_from_other(face);
  const int vertex = frame.support(face), before = frame.other.previous(vertex);
  return normal.dot(frame.other.normal(before)) < normal.dot(frame.other.normal(vertex)) ? before : vertex;
}

/// The part of the facing edge in front of the face, or the support vertex alone. None when the edge lies
/// beside the face and does not overlap it: two corners that pass each other do not touch.
void clip(const OwnerFrame& frame, bool overlaps, Manifold<2>& manifold) {
  const int face = manifold.feature, edge = facing_edge(frame, face);
  const Vector<2> start = frame.owner.vertex(face);
  const Vector<2> along = perpendicular(frame.owner.normal(face));
  const double length = along.dot(frame.owner.vertex(frame.owner.next(face)) - start);
  // The facing edge runs against the face: its end comes first.
  const int first = frame.other.next(edge), last = edge;
  const double s_first = along.dot(frame.other_vertex(first) - start);
  const double s_last = along.dot(frame.other_vertex(last) - start);
  const double from = std::max(0.0, s_first), to = std::min(length, s_last);
  const double flush = touch_reach * length;
  if (!(to - from > flush)) {
    const int vertex = frame.support(face);
    const double s = along.dot(frame.other_vertex(vertex) - start);
    manifold.count = overlaps || (s > flush && s < length - flush) ? 1 : 0;
    manifold.point = {frame.other.vertex(vertex), Vector<2>::Zero()};
    return;
  }
  const Vector<2> start_of_edge = frame.other.vertex(first);
  const Vector<2> way = frame.other.vertex(last) - start_of_edge;
  const auto point_at = [&](double s) -> Vector<2> {
    return start_of_edge + (s - s_first) / (s_last - s_first) * way;
  };
  manifold.count = 2;
  manifold.point[0] = point_at(from);
  manifold.point[1] = point_at(to);
}

}  // namespace

bool find_manifold(const PosedBlock<2>& a, const PosedBlock<2>& b, double margin, Manifold<2>& manifold) {
  const OwnerFrame frames[2] = {{a, b}, {b, a}};
  const int owner = manifold.plane == ManifoldPlane::face_of_b;
  const double size = std::abs(frames[owner].owner.offset[manifold.feature]);
  const double equal = face_reach * size;
  FaceOfLargestSeparation best{owner, manifold.feature, frames[owner].separation(manifold.feature)};
  best.try_all(frames[0], 0, margin, equal);
  best.try_all(frames[1], 1, margin, equal);
  manifold.plane = best.owner == 0 ? ManifoldPlane::face_of_a : ManifoldPlane::face_of_b;
  manifold.feature = best.face;
  if (best.separation > margin) return false;
  clip(frames[best.owner], best.separation < -touch_reach * size, manifold);
  return manifold.count > 0;
}

Vector<2> normal_of(const Manifold<2>& manifold, const PosedBlock<2>& a, const PosedBlock<2>& b) {
  if (manifold.plane == ManifoldPlane::face_of_a) return a.rotation * a.own.normal(manifold.feature);
  return -(b.rotation * b.own.normal(manifold.feature));
}

}  // namespace halfspace
