#include <span>

#include "force/spring/pressure_sums.h"
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
    part.push_back({other.vertex(v), outline.normal(v), other.block, false});
    v = outline.next(v);
  } while (v != first && is_below(v));
  if (v != first) part.push_back({other.vertex(v), face.normal, 1 - other.block, false});
}

/// Keeps what lies behind an edge of the owner. Where a side lies on that edge, up to rounding, it stays, and
/// is shared.
void cut(const Face& face, int block, PressureRoom<2>& room) {
  Array<OverlapCorner>& whole = room.overlap;
  if (whole.empty()) return;
  bool is_whole = true;
  for (std::size_t i = 0, last = whole.size() - 1; i <= last; ++i) {
    const double here = face.depth(whole[i].at);
    is_whole &= here >= 0;
    const double next = face.depth(whole[i == last ? 0 : i + 1].at);
    if (are_flush(face, whole[i].normal, here) && are_flush(face, whole[i].normal, next)) {
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
    // From its inner to its outer end, so that both blocks get the same bits.
    const Vector<2>&inner = here >= 0 ? side.start.at : side.end.at,
          &outer = here >= 0 ? side.end.at : side.start.at;
    const double depth = std::max(here, next), height = -std::min(here, next);
    const Vector<2> at = inner + depth / (depth + height) * (outer - inner);
    part.push_back(here >= 0 ? OverlapCorner{at, face.normal, block, false} : side.start);
    part.back().at = at;
  });
  room.overlap.swap(room.clipped);
}

/// Cuts by the edges of the owner that lie less deep than the other block reaches, from the contact face on
/// to both sides. Deeper ones do not bound the overlap.
void cut_by_owner(const Face& face, const Placed& owner, int edge, double reach, PressureRoom<2>& room) {
  const Outline<2>& outline = owner.outline;
  const auto cut_by = [&](int e) { cut(Face(owner, e), owner.block, room); };
  const auto is_reached = [&](int v) { return face.depth(owner.vertex(v)) < reach; };
  cut_by(edge);
  int last = outline.next(edge);
  for (; last != edge && is_reached(last); last = outline.next(last)) cut_by(last);
  for (int first = edge; first != last && is_reached(first);) {
    first = outline.previous(first);
    cut_by(first);
  }
}

/// The depth below a face, integrated over the overlap. By the divergence theorem it is an integral over the
/// sides.
double energy_below(const Face& face, std::span<const OverlapCorner> overlap) {
  double energy = 0;
  for_each_side(overlap, [&](const Side& side) {
    const double here = face.depth(side.start.at), next = face.depth(side.end.at);
    const double mean_square = (here * here + here * next + next * next) / 3;
    energy -= 0.5 * face.normal.dot(side.start.normal) * side.length() * mean_square;
  });
  return energy;
}

PressureSums<2> sums_below(const Face& face, int owner, std::span<const OverlapCorner> overlap) {
  PressureSums<2> sums;
  for_each_side(overlap, [&](const Side& side) {
    const Vector<2>&p = side.start.at, &q = side.end.at, &normal = side.start.normal;
    const double here = face.depth(p), next = face.depth(q), length = side.length();
    if (side.start.block != owner || side.start.is_shared) {
      const double pressed = side.start.is_shared ? 0.5 * length : length;
      sums.add_pressure(normal, pressed / 2 * (here + next),
                        pressed / 6 * (here * (2 * p + q) + next * (p + 2 * q)));
    }
    const double width = -face.normal.dot(normal) * length;
    if (width > 0) sums.add_base(p + here * face.normal, q + next * face.normal, width);
  });
  return sums;
}

}  // namespace

Pressure<2> pressure_between(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                             const PotentialPair<2>& near, PressureRoom<2>& room) {
  const Placed blocks[] = {{a, Vector<2>::Zero(), 0}, {b, to_b, 1}};
  const Placed &start = blocks[near.owner], &other = blocks[1 - near.owner];
  const Face first(start, near.edge);
  const int deepest = deepest_vertex(other.outline, first.normal, near.vertex);
  const double reach = first.depth(other.vertex(deepest));
  Pressure<2> pressure;
  if (!(reach > 0)) return pressure;
  begin_below(first, other, deepest, room.overlap);
  cut_by_owner(first, start, near.edge, reach, room);
  const std::span<const OverlapCorner> overlap = room.overlap;
  if (overlap.size() < 3) return pressure;

  const auto place_of = [](const OverlapCorner& corner) { return corner.at; };
  const LeastFace least = least_face(
      blocks, [&](const Face& face, double limit) { return greatest_depth(face, overlap, limit, place_of); },
      [&](const Face& face) { return energy_below(face, overlap); });
  if (!least.is_found()) return pressure;
  const Placed &owner = blocks[least.block], &pressed = blocks[1 - least.block];
  const Face face(owner, least.face);
  const PressureSums<2> sums = sums_below(face, least.block, overlap);
  if (!(sums.base > 0)) return pressure;
  const int vertex = deepest_vertex(pressed.outline, face.normal, near.vertex);
  const PotentialPair<2> pair{least.block, least.face, vertex};
  return sums.pressure(pair, face.normal, least.energy, owner, pressed);
}

}  // namespace halfspace
