#pragma once

#include "narrow_phase/contact.h"
#include "narrow_phase/space/seen_outline.h"

namespace halfspace {

// The counterparts in space of what pair.h has for the plane. Outlines are in one orientation, each relative
// to its own centroid; `to_b` leads from that of a to that of b.

/// Gap of a potential pair along its normal, with the deepest vertex of a face's half-space brought up to
/// date. Of two edges, the gap between what both blocks reach along edge_pair_normal(): however the blocks
/// have turned, above 0 it proves separation; -infinity where the edges are parallel. Not for two vertices.
double refresh(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b, PotentialPair<3>& pair);

/// Gap of what keeps two blocks apart: of a face and a vertex; or, of two edges or vertices, between what
/// both blocks reach along the remembered normal, which two edges renew when it no longer does. Vertices are
/// brought up to date only where that helps to find them next time.
double refresh(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, PairCache<3>& witness);

/// True when blocks that touched are easily seen to touch still: where the remembered pair is, or at the
/// remembered point.
bool still_touching(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, PairCache<3>& witness);

/// Remembers a point of both blocks in the middle of a contact: at a face, half as deep as that is.
void remember_proof(const Contact<3>& contact, const Vector<3>& to_b, PairCache<3>& witness);
/// Remembers a known point of blocks that touch.
inline void remember_point(const Vector<3>& point, PairCache<3>& witness) {
  if (touching(witness)) witness.proof = point;
}

/// The pair through which blocks begin to meet that were separated at last (Wang et al. 2021, section 2.5):
/// the violated one; or, when only a plane is remembered, the less deep of those whose faces look most along
/// it from either side.
PotentialPair<3> initial_pair(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                              const PairCache<3>& witness);

/// The less deep of the pairs whose faces look most along a normal from a to b, from either side.
inline PotentialPair<3> pair_along(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                                   const Vector<3>& normal) {
  constexpr PotentialPair<3> anywhere{PotentialPair<3>::vertex_vertex, 0, 0};
  return initial_pair(a, b, to_b, {PairCache<3>::separated, anywhere, normal});
}

/// Walks over the Minkowski difference to the pair of least depth that is reached without passing a deeper
/// one. So the contact keeps the side through which the blocks met, also when a thin block is overlapped past
/// its middle.
PotentialPair<3> descend(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                         const PotentialPair<3>& start);

/// Type, normal, gap and region of the contact at a potential pair, touching or not. The vertex of a face is
/// brought up to date; not for two vertices.
///
/// `pair` is moved over the Minkowski difference as long as the contact point lies beyond an end of its edge
/// or outside its face; edges that have ceased to be a potential pair first become the least deep of their
/// faces. Of blocks that overlap each move takes it to a lesser depth, so that they come to an end by
/// themselves. In any case there are no more of them than both blocks have edges, nor one straight back: then
/// the edge or end that the contact point lies beyond stands in.
void describe_contact(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                      PotentialPair<3>& pair, const DetectOptions& options, Contact<3>& contact);

/// The contact of blocks that touched, if it is at a point and shows by itself that they touch still: as a
/// rule, then, of a pair from step to step. False else, and nothing is known yet.
bool describe_plainly_touching(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                               const PairCache<3>& witness, const DetectOptions& options,
                               Contact<3>& contact);

inline PairCache<3> witness_of(const Separation<3>& separation) {
  return {PairCache<3>::separated, separation.pair, separation.normal};
}

}  // namespace halfspace
