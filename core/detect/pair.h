#pragma once

#include "detect/contact.h"
#include "detect/separation.h"
#include "geometry/outline.h"

namespace halfspace {

/// Gap of a potential pair whose vertex may have moved on: `pair.vertex` is brought up to date. Seen from the
/// frame of the owner, as far as the vertex allows.
template <class Lanes>
double refresh(const Outline<2>& a, const Outline<2>& b, const Placement<Lanes>& at, PotentialPair<2>& pair) {
  const Owner owner(a, b, pair);
  const Vector<2> normal = owner.block.normal(pair.edge);
  const Vector<2> seen_from_other = only(at.into_other, pair.owner) * normal;
  pair.vertex = deepest_vertex(owner.other, seen_from_other, pair.vertex);
  return (height_along(seen_from_other, owner.other, pair.vertex) +
          normal.dot(only(at.to_other, pair.owner))) -
         owner.block.offset[pair.edge];
}

/// The same for outlines in one orientation.
inline double refresh(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                      PotentialPair<2>& pair) {
  return refresh(a, b, placement_unturned(to_b), pair);
}

/// True when the remembered pair is still violated, which proves separation by itself (Wang et al. 2021, eq.
/// 12).
inline bool still_separated(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                            PairMemory<2>& memory) {
  return memory.state == PairMemory<2>::separated && refresh(a, b, to_b, memory.pair) > 0;
}

/// Walks around the Minkowski difference to the pair of least depth that is reached without passing a deeper
/// one. So the contact keeps the side through which the blocks met, also when a thin block is overlapped past
/// its middle.
PotentialPair<2> descend(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                         const PotentialPair<2>& start);

/// The pair through which blocks meet that are found to overlap: the last violated one, or a neighbour of it
/// that is less deep; the one remembered when they touched before; without history the given one, of least
/// depth (section 2.5). Remembers it, with its vertex brought up to date.
inline void remember_contact(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                             const PotentialPair<2>& least_depth, PairMemory<2>& memory) {
  if (memory.state == PairMemory<2>::separated) {
    memory.pair = descend(a, b, to_b, memory.pair);
  } else {
    if (memory.state == PairMemory<2>::unknown) memory.pair = least_depth;
    refresh(a, b, to_b, memory.pair);
  }
  memory.state = PairMemory<2>::touching;
}

/// Type, normal, gap and region of the contact at a potential pair, touching or not. `pair` is moved to the
/// neighbouring one when the vertex has left the edge across its end.
void describe_contact(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, PotentialPair<2>& pair,
                      const DetectOptions& options, Contact<2>& contact);

/// Describes the contact of two blocks that overlap.
inline void describe_overlap(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                             const PotentialPair<2>& least_depth, const DetectOptions& options,
                             PairMemory<2>& memory, Contact<2>& contact) {
  remember_contact(a, b, to_b, least_depth, memory);
  describe_contact(a, b, to_b, memory.pair, options, contact);
}

/// Judges all potential pairs of two blocks, and remembers the contact or the separation.
inline void judge_pair(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                       PairMemory<2>& memory) {
  const Separation<2> separation = find_separation(a, b, to_b);
  if (separation.gap > 0) {
    memory = {PairMemory<2>::separated, separation.pair};
  } else {
    remember_contact(a, b, to_b, separation.pair, memory);
  }
}

}  // namespace halfspace
