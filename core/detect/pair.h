#pragma once

#include "detect/contact.h"
#include "detect/separation.h"
#include "geometry/outline.h"

namespace halfspace {

/// Gap of a potential pair whose vertex may have moved on: `pair.vertex` is brought up to date.
inline double refresh(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, PotentialPair& pair) {
  const bool a_owns = pair.owner == 0;
  const Outline<2>& owner = a_owns ? a : b;
  const Outline<2>& other = a_owns ? b : a;
  pair.vertex = deepest_vertex(other, owner.normal(pair.edge), pair.vertex);
  return edge_gap(owner, pair.edge, other, pair.vertex, a_owns ? to_b : Vector<2>(-to_b));
}

/// True when the remembered pair is still violated, which proves separation by itself (Wang et al. 2021, eq.
/// 12).
inline bool still_separated(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                            PairMemory& memory) {
  return memory.state == PairMemory::separated && refresh(a, b, to_b, memory.pair) > 0;
}

/// The pair through which blocks meet that are found to overlap: the last violated one, or a neighbour of it
/// that is less deep; the one remembered when they touched before; without history the given one, of least
/// depth (section 2.5). Remembers it.
void remember_contact(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                      const PotentialPair& least_depth, PairMemory& memory);

/// Type, normal, gap and region of the contact at a potential pair, touching or not. `pair` is moved to the
/// neighbouring one when the vertex has left the edge across its end.
void describe_contact(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, PotentialPair& pair,
                      const DetectOptions& options, Contact<2>& contact);

/// Describes the contact of two blocks that overlap.
inline void describe_overlap(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                             const PotentialPair& least_depth, const DetectOptions& options,
                             PairMemory& memory, Contact<2>& contact) {
  remember_contact(a, b, to_b, least_depth, memory);
  describe_contact(a, b, to_b, memory.pair, options, contact);
}

/// Judges all potential pairs of two blocks, and remembers the contact or the separation.
inline void judge_pair(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, PairMemory& memory) {
  const Separation separation = find_separation(a, b, to_b);
  if (separation.gap > 0) {
    memory = {PairMemory::separated, separation.pair};
  } else {
    remember_contact(a, b, to_b, separation.pair, memory);
  }
}

}  // namespace halfspace
