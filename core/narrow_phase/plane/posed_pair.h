#pragma once

#include "narrow_phase/pair.h"
#include "narrow_phase/plane/turned_outline.h"
#include "narrow_phase/posed_pair.h"

namespace halfspace {

/// Tests all potential pairs of polygons with at most `max_vertices` vertices each, within
/// max_combinations. The known bound allows loops to be unrolled.
template <int max_vertices>
[[gnu::always_inline]] inline Separation<2> find_separation_of_few(const PosedPair<2>& posed,
                                                                   const Placement<Turns>& seen) {
  const Outline<2>&a = posed.a.outline(), &b = posed.b.outline();
  const auto is_known = [](int count) { return count >= 3 && count <= max_vertices; };
  if (!is_known(a.count) || !is_known(b.count)) __builtin_unreachable();
  return find_separation_by_all(a, b, seen);
}

/// A contact without region at a given pair.
[[gnu::always_inline]] inline Contact<2> contact_at(const Separation<2>& found, ContactType type,
                                                    const PosedPair<2>& posed, const Turns& turns) {
  const Owner owner(posed.a.outline(), posed.b.outline(), found.pair);
  const Vector<2> normal = only(turns, found.pair.owner) * owner.block.normal(found.pair.edge);
  return contact_without_region<2>(type, found.pair, owner.sign * normal, found.gap);
}

/// The contact of overlapping polygons, with b in the frame of a.
inline Contact<2> describe_overlap(const PosedPair<2>& posed, const Outline<2>& b, const Vector<2>& to_b,
                                   const Rotation<2>& frame_of_a, const PotentialPair<2>& min_depth,
                                   const DetectOptions& options, PairCache<2>& witness) {
  Contact<2> contact;
  describe_overlap(posed.a.outline(), b, to_b, min_depth, options, witness, contact);
  place(contact, frame_of_a, Vector<2>(posed.at_a.position));
  return contact;
}

/// Tests the shapes, each in its own frame as long as possible, and caches the pair. The contact is in the
/// host's frame. `room` allocates the outline of a polygon of many vertices. Always inlined, as the result
/// would otherwise be passed through memory.
[[gnu::always_inline]] inline Contact<2> search_pair(const PosedPair<2>& posed, const Frames<2>& frames,
                                                     const PairOptions& options, PairCache<2>& witness,
                                                     Memory* room) {
  const Outline<2>&a = posed.a.outline(), &b = posed.b.outline();
  const auto without_region = [&](Separation<2> found) {
    const bool apart = found.gap > options.margin;
    if (!apart) found.gap = refresh(a, b, frames.seen, found.pair);  // computes the vertex, needed only now
    witness = {apart ? PairCache<2>::separated : PairCache<2>::unknown, found.pair};
    return contact_at(found, apart ? ContactType::none : ContactType::vertex_edge, posed, frames.turns);
  };
  if (witness.state == PairCache<2>::separated) {
    const double gap = refresh(a, b, frames.seen, witness.pair);
    if (gap > options.margin) return without_region({gap, witness.pair});
  }
  Separation<2> found;
  const auto is_found = [&] { return found.gap > options.margin || !options.with_region; };
  const bool by_all = by_all_combinations(a, b);
  if (by_all) {
    found = find_separation_by_all(a, b, frames.seen, options.margin);
    if (is_found()) return without_region(found);
  }
  const Vector<2> to_b = frames.to_b();
  const TurnedPolygon turned(b, frames.b_in_a(), room);
  if (!by_all) {
    found = find_separation_by_merge(a, turned.outline(), to_b, options.margin);
    if (is_found()) return without_region(found);
  }
  return describe_overlap(posed, turned.outline(), to_b, frames.of_a(), found.pair, options, witness);
}

}  // namespace halfspace
