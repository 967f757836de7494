#pragma once

#include "narrow_phase/contact.h"
#include "narrow_phase/space/seen_outline.h"

namespace halfspace {

// The counterparts in 3D of the functions for 2D in pair.h. Outlines are in one orientation, each relative to
// its own centroid; `to_b` is the vector from the centroid of a to that of b.

/// Gap of a potential pair along its normal; updates the deepest vertex of a face's half-space. For two
/// edges, the gap between the supports of both blocks along edge_pair_normal(): for any orientations it
/// proves separation if positive; -infinity for parallel edges. Not for two vertices.
double refresh(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b, PotentialPair<3>& pair);

/// Gap of the cached proof of separation: of a face and a vertex; or, for two edges or vertices, between the
/// supports of both blocks along the cached normal, which two edges update when it fails. Vertices are
/// updated only where that accelerates the next search.
double refresh(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, PairCache<3>& witness);

/// True when blocks that touched are easily proven to touch still: by the cached pair or the cached point.
bool still_touching(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, PairCache<3>& witness);

/// Caches a point of both blocks, in the middle of a contact; at a face, at half the depth.
void remember_proof(const Contact<3>& contact, const Vector<3>& to_b, PairCache<3>& witness);
/// Caches a given point of touching blocks.
inline void remember_point(const Vector<3>& point, PairCache<3>& witness) {
  if (touching(witness)) witness.proof = point;
}

/// The pair through which separated blocks start to touch (Wang et al. 2021, section 2.5): the violated one;
/// or, if only a plane is cached, pair_along() its normal.
PotentialPair<3> initial_pair(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                              const PairCache<3>& witness);

/// The pair of smaller depth, of a's face with its normal nearest to `normal` and b's nearest to -`normal`.
inline PotentialPair<3> pair_along(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                                   const Vector<3>& normal) {
  constexpr PotentialPair<3> anywhere{PotentialPair<3>::vertex_vertex, 0, 0};
  return initial_pair(a, b, to_b, {PairCache<3>::separated, anywhere, normal});
}

/// Walks over the Minkowski difference to the pair of minimum depth that is reached without passing a deeper
/// one. So the contact stays on the side through which the blocks met, also when a thin block is penetrated
/// beyond its middle.
PotentialPair<3> descend(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                         const PotentialPair<3>& start);

/// Computes type, normal, gap and region of the contact at a potential pair, touching or not. Updates the
/// vertex of a face; not for two vertices.
///
/// Moves `pair` over the Minkowski difference while the contact point is beyond an end of its edge or outside
/// its face; edges that are no longer a potential pair are first replaced by their face of smallest depth.
/// For overlapping blocks each move reduces the depth, so that the walk ends. In any case there are at most
/// as many moves as both blocks have edges, and none straight back: then the contact is at the edge or end
/// that was passed.
void describe_contact(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                      PotentialPair<3>& pair, const DetectOptions& options, Contact<3>& contact);

/// Describes the contact of blocks that touched, if it is at a point and proves contact, as it usually does
/// from step to step. False decides nothing.
bool describe_plainly_touching(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                               const PairCache<3>& witness, const DetectOptions& options,
                               Contact<3>& contact);

inline PairCache<3> witness_of(const Separation<3>& separation) {
  return {PairCache<3>::separated, separation.pair, separation.normal};
}

}  // namespace halfspace
