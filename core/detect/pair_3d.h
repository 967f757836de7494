#pragma once

#include "detect/contact.h"
#include "geometry/outline.h"

namespace halfspace {

// The counterparts in space of what pair.h has for the plane. Outlines are in one orientation, each relative
// to its own centroid; `to_b` leads from that of a to that of b.

/// Gap of a potential pair along its normal, with the deepest vertex of a face's half-space brought up to
/// date. Of two edges, the gap between what both blocks reach along edge_pair_normal(): however the blocks
/// have turned, above 0 it proves separation. The same for two vertices along the line between them, except
/// that each moves on to the vertex deepest along that line. -infinity where there is no such line, or the
/// edges are parallel.
double refresh(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, PotentialPair<3>& pair);

/// True when the remembered pair is still violated, which proves separation by itself (Wang et al. 2021, eq.
/// 31).
inline bool still_separated(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                            PairMemory<3>& memory) {
  return memory.state == PairMemory<3>::separated && refresh(a, b, to_b, memory.pair) > 0;
}

/// The pair through which blocks meet that are found to overlap: from the last violated one, the pair of
/// least depth that a walk over the Minkowski difference reaches without passing a deeper one; the one
/// remembered when they touched before; without history, or when only a plane between two vertices is
/// remembered, the given one, of least depth (section 2.5). Remembers it.
void remember_contact(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                      const PotentialPair<3>& least_depth, PairMemory<3>& memory);

/// Type, normal, gap and region of the contact at a potential pair, touching or not. The vertex of a face is
/// the deepest one, as refresh() leaves it; not for two vertices.
///
/// `pair` is moved over the Minkowski difference as long as the contact point lies beyond an end of its edge
/// or outside its face; edges that have ceased to be a potential pair first become the least deep of their
/// faces. Of blocks that overlap each move takes it to a lesser depth, so that they come to an end by
/// themselves. In any case there are no more of them than both blocks have edges, nor one straight back: then
/// the edge or end that the contact point lies beyond stands in.
void describe_contact(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, PotentialPair<3>& pair,
                      const DetectOptions& options, Contact<3>& contact);

/// Describes the contact of two blocks that overlap.
inline void describe_overlap(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                             const PotentialPair<3>& least_depth, const DetectOptions& options,
                             PairMemory<3>& memory, Contact<3>& contact) {
  remember_contact(a, b, to_b, least_depth, memory);
  describe_contact(a, b, to_b, memory.pair, options, contact);
}

}  // namespace halfspace
