#include <span>

#include "force/spring/pressure_sums.h"
#include "geometry/polygon/clip.h"
#include "narrow_phase/plane/separation.h"

namespace halfspace {
namespace {

using Placed = PlacedOutline<2>;
using Face = PressureFace<2>;

/// A side of the overlap, from a corner to the next.
struct Side {
  const OverlapCorner& start;
  const OverlapCorner& end;

  double length() const { return (end.at - start.at).norm(); }
};

template <class Visitor>
void for_each_side(std::span<const OverlapCorner> overlap, Visitor visit) {
  for (std::size_t i = 0, last = overlap.size() - 1; i <= last; ++i)
    visit(Side{overlap[i], overlap[i == last ? 0 : i + 1]});
}

/// The part of the other block below the contact face: its edges around the deepest vertex, closed by a chord
/// above the face.
void begin_below(const Face& face, const Placed& other, int deepest, Array<OverlapCorner>& part) {
  const Outline<2>& outline = other.outline;
  const auto is_below = [&](int v) { return face.depth(other.vertex(v)) > 0; };
  int first = outline.previous(deepest);
  while (first != deepest && is_below(first)) first = outline.previous(first);
  part.clear();
  int v = first;
  do {
    part.push_back({other.vertex(v), outline.normal(v), other.block, v, flush_of(other, v), false});
    v = outline.next(v);
  } while (v != first && is_below(v));
  if (v != first) part.push_back({other.vertex(v), face.normal, face.block, face.face, face.flush, false});
}

/// Keeps what lies behind an edge of the owner. Where a side lies on that edge, up to rounding, it stays, and
/// is shared.
void cut(const Face& face, PressureRoom<2>& room) {
  Array<OverlapCorner>& whole = room.overlap;
  if (whole.empty()) return;
  bool is_whole = true;
  for (std::size_t i = 0, last = whole.size() - 1; i <= last; ++i) {
    const double here = face.depth(whole[i].at);
    is_whole &= here >= 0;
    const double next = face.depth(whole[i == last ? 0 : i + 1].at);
    const bool is_flush = std::max(std::abs(here), std::abs(next)) <= std::min(face.flush, whole[i].flush);
    if (is_flush && are_parallel(face.normal, whole[i].normal)) {
      whole[i].is_shared = true;
      return;
    }
  }
  if (is_whole) return;
  Array<OverlapCorner>& part = room.clipped;
  part.clear();
  for_each_side(whole, [&](const Side& side) {
    const double here = face.depth(side.start.at), next = face.depth(side.end.at);
    if (here >= 0) part.push_back(side.start);
    if ((here >= 0) == (next >= 0)) return;
    const Vector<2>&inner = here >= 0 ? side.start.at : side.end.at,
          &outer = here >= 0 ? side.end.at : side.start.at;
    const double depth = std::max(here, next), height = -std::min(here, next);
    const Vector<2> at = crossing(inner, -depth, outer, height);
    part.push_back(here >= 0 ? OverlapCorner{at, face.normal, face.block, face.face, face.flush, false}
                             : side.start);
    part.back().at = at;
  });
  room.overlap.swap(room.clipped);
}

/// Cuts by the edges of the owner that lie less deep than the other block reaches, from the contact face on
/// to both sides. Deeper ones do not bound the overlap.
void cut_by_owner(const Face& face, const Placed& owner, int edge, double reach, PressureRoom<2>& room) {
  const Outline<2>& outline = owner.outline;
  const auto cut_by = [&](int e) { cut(face_of(owner, e), room); };
  const auto is_reached = [&](int v) { return face.depth(owner.vertex(v)) < reach; };
  cut_by(edge);
  int last = outline.next(edge);
  for (; last != edge && is_reached(last); last = outline.next(last)) cut_by(last);
  for (int first = edge; first != last && is_reached(first);) {
    first = outline.previous(first);
    cut_by(first);
  }
}

OverlapVolume<2> area_of(std::span<const OverlapCorner> overlap) {
  const Vector<2>& apex = overlap.front().at;
  double twice_area = 0;
  Vector<2> moment = Vector<2>::Zero();
  for (std::size_t i = 1; i + 1 < overlap.size(); ++i) {
    const Vector<2> p = overlap[i].at - apex, q = overlap[i + 1].at - apex;
    const double twice = cross(p, q);
    twice_area += twice;
    moment += twice * (p + q);
  }
  if (!(twice_area > 0)) return {0, apex};
  return {0.5 * twice_area, apex + moment / (3 * twice_area)};
}

PressureSums<2> sums_below(const Face& face, std::span<const OverlapCorner> overlap) {
  PressureSums<2> sums;
  for_each_side(overlap, [&](const Side& side) {
    const Vector<2>&p = side.start.at, &q = side.end.at, &normal = side.start.normal;
    const double here = face.depth(p), next = face.depth(q);
    sums.depth = std::max(sums.depth, here);
    if (const double part = kept_part(side.start, face) * side.length(); part > 0)
      sums.keep(normal, part / 2 * (here + next), part / 6 * (here * (2 * p + q) + next * (p + 2 * q)));
    const double faces_up = face.normal.dot(normal);
    if (faces_up > 0) sums.add_base(p, q, faces_up * side.length());
  });
  return sums;
}

/// Finds the overlap from a pair on, and updates its vertex.
void find_overlap(const Placed (&blocks)[2], const Face& first, PotentialPair<2>& pair,
                  PressureRoom<2>& room) {
  const Placed &owner = blocks[first.block], &other = blocks[1 - first.block];
  pair.vertex = deepest_vertex(other.outline, first.normal, pair.vertex);
  const double reach = first.depth(other.vertex(pair.vertex));
  room.overlap.clear();
  if (!(reach > 0)) return;
  begin_below(first, other, pair.vertex, room.overlap);
  cut_by_owner(first, owner, first.face, reach, room);
}

}  // namespace

Pressure<2> pressure_between(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                             const PotentialPair<2>& near, PressureRoom<2>& room) {
  const Placed blocks[] = {{a, Vector<2>::Zero(), 0}, {b, to_b, 1}};
  PotentialPair<2> pair = near;
  for (bool is_second = false;; is_second = true) {
    const Face first = face_of(blocks[pair.owner], pair.edge);
    find_overlap(blocks, first, pair, room);
    const std::span<const OverlapCorner> overlap = room.overlap;
    if (overlap.size() < 3) return no_pressure(first);
    const OverlapVolume<2> area = area_of(overlap);
    const Face face = face_of_min_energy(blocks, first, overlap, area.centroid);
    const bool is_own = face.is_same(first);
    if (!is_own) pair = {face.block, face.face, face.block == pair.owner ? pair.vertex : 0};
    if (is_own || is_second) return sums_below(face, overlap).pressure(pair, face, area);
  }
}

}  // namespace halfspace
