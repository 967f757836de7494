#pragma once

#include "geometry/outline.h"
#include "geometry/tolerances.h"
#include "narrow_phase/contact.h"
#include "narrow_phase/plane/separation.h"
#include "narrow_phase/space/pair.h"
#include "narrow_phase/space/separation.h"

namespace halfspace {

/// Gap of a potential pair; updates its vertex to the deepest one. Computed in the frame of the edge's owner.
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

/// Gap of the cached pair of separated blocks.
inline double refresh(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                      PairCache<2>& witness) {
  return refresh(a, b, to_b, witness.pair);
}

/// The pair through which separated blocks start to touch (Wang et al. 2021, section 2.5).
inline PotentialPair<2> initial_pair(const Outline<2>&, const Outline<2>&, const Vector<2>&,
                                     const PairCache<2>& witness) {
  return witness.pair;
}

/// Does the line through a vertex behind the cached pair's edge, parallel to that between the centroids, meet
/// the edge? Then the blocks overlap, as in 3D (space/witness.cpp). Of parallel edges the other vertex may be
/// the one that proves it. Updates the vertex.
inline bool still_touching(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                           PairCache<2>& witness) {
  if (witness.state != PairCache<2>::touching) return false;
  refresh(a, b, to_b, witness.pair);
  const Owner owner(a, b, witness.pair);
  const int edge = witness.pair.edge, deepest = witness.pair.vertex;
  const Vector<2> normal = owner.block.normal(edge), to_other = owner.sign * to_b;
  const Vector<2> start = owner.block.vertex(edge), end = owner.block.vertex(owner.block.next(edge));
  const double rise = normal.dot(to_other);
  if (!(rise > machine_epsilon * to_other.cwiseAbs().maxCoeff())) return false;
  for (const int v : {deepest, owner.other.next(deepest), owner.other.previous(deepest)}) {
    const double depth = -edge_gap(owner.block, edge, owner.other, v, to_other);
    const Vector<2> on_edge = owner.other.vertex(v) + (1 + depth / rise) * to_other;
    if (depth >= 0 && (on_edge - start).dot(end - start) >= 0 && (end - on_edge).dot(end - start) >= 0)
      return true;
  }
  return false;
}
inline bool describe_plainly_touching(const Outline<2>&, const Outline<2>&, const Vector<2>&,
                                      const PairCache<2>&, const DetectOptions&, Contact<2>&) {
  return false;
}
inline void remember_proof(const Contact<2>&, const Vector<2>&, PairCache<2>&) {}
inline void remember_point(const Vector<2>&, PairCache<2>&) {}

/// Unit normal of a potential pair's half-space, oriented from a to b.
inline Vector<2> normal_of(const Outline<2>& a, const Outline<2>& b, const PotentialPair<2>& pair) {
  return pair.owner == 0 ? a.normal(pair.edge) : Vector<2>(-b.normal(pair.edge));
}

/// The pair of smaller depth, of a's edge with its normal nearest to `normal` and b's nearest to -`normal`.
PotentialPair<2> pair_along(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                            const Vector<2>& normal);

/// Walks around the Minkowski difference to the pair of minimum depth that is reached without passing a
/// deeper one. So the contact stays on the side through which the blocks met, also when a thin block is
/// penetrated beyond its middle.
PotentialPair<2> descend(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                         const PotentialPair<2>& start);

/// Computes type, normal, gap and region of the contact at a potential pair, touching or not. Replaces `pair`
/// by the neighbouring one when the vertex has left the edge across its end.
void describe_contact(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, PotentialPair<2>& pair,
                      const DetectOptions& options, Contact<2>& contact);

inline PairCache<2> witness_of(const Separation<2>& separation) {
  return {PairCache<2>::separated, separation.pair};
}

// From here on for 2D and 3D. Outlines are in one orientation, each relative to its own centroid; `to_b` is
// the vector from the centroid of a to that of b.

/// Does the cached pair still prove separation (eqs. 12 and 31)?
template <int D>
bool still_separated(const Outline<D>& a, const Outline<D>& b, const Vector<D>& to_b, PairCache<D>& witness) {
  return witness.state == PairCache<D>::separated && refresh(a, b, to_b, witness) > 0;
}

/// Caches the pair through which overlapping blocks have met, and updates its vertex: after separation the
/// pair through which they start to touch, or one of smaller depth reached by a walk from it; after contact
/// the cached one; without history the given one, of minimum depth (section 2.5).
template <int D>
void remember_contact(const Seen<D>& a, const Seen<D>& b, const Vector<D>& to_b,
                      const PotentialPair<D>& min_depth, PairCache<D>& witness) {
  if (witness.state == PairCache<D>::separated) {
    witness.pair = descend(a, b, to_b, initial_pair(a, b, to_b, witness));
  } else {
    if (witness.state != PairCache<D>::touching) witness.pair = min_depth;
    refresh(a, b, to_b, witness.pair);
  }
  witness.state = PairCache<D>::touching;
}

/// Computes type, normal, gap and region of the contact at the cached pair. In 3D also caches a point of both
/// blocks, as a faster proof of contact in the next step.
template <int D>
void describe_contact(const Seen<D>& a, const Seen<D>& b, const Vector<D>& to_b, PairCache<D>& witness,
                      const DetectOptions& options, Contact<D>& contact) {
  describe_contact(a, b, to_b, witness.pair, options, contact);
  if (witness.state == PairCache<D>::touching) remember_proof(contact, to_b, witness);
}

template <int D>
void describe_overlap(const Seen<D>& a, const Seen<D>& b, const Vector<D>& to_b,
                      const PotentialPair<D>& min_depth, const DetectOptions& options, PairCache<D>& witness,
                      Contact<D>& contact) {
  remember_contact(a, b, to_b, min_depth, witness);
  describe_contact(a, b, to_b, witness, options, contact);
}

/// Tests all potential pairs of two blocks, unless they are proven to touch, and caches the contact or the
/// separation.
template <int D>
void judge_pair(const Outline<D>& a, const Outline<D>& b, const Vector<D>& to_b, PairCache<D>& witness) {
  if (still_touching(a, b, to_b, witness)) return;
  const Separation<D> separation = find_separation(a, b, to_b);
  if (separation.gap > 0) {
    witness = witness_of(separation);
  } else {
    remember_contact(a, b, to_b, separation.pair, witness);
  }
}

/// Do two blocks touch?
template <int D>
bool touch(const Outline<D>& a, const Outline<D>& b, const Vector<D>& to_b, PairCache<D>& witness) {
  if (!still_separated(a, b, to_b, witness)) judge_pair(a, b, to_b, witness);
  return touching(witness);
}

/// The contact pair of touching blocks: the cached one, or that of minimum depth.
template <int D>
PotentialPair<D> pair_in_contact(const Outline<D>& a, const Outline<D>& b, const Vector<D>& to_b,
                                 const PairCache<D>& witness) {
  if (witness.state != PairCache<D>::overlapping) return witness.pair;
  const Separation<D> separation = find_separation(a, b, to_b);
  // To rounding they may be separated.
  return separation.gap > 0 ? initial_pair(a, b, to_b, witness_of(separation)) : separation.pair;
}

/// If two blocks touch, describes their contact and returns true. The result is that of touch() followed by
/// describe_contact(), but a contact that has hardly changed is proven by its description.
template <int D>
bool find_contact(const Outline<D>& a, const Outline<D>& b, const Vector<D>& to_b,
                  const DetectOptions& options, PairCache<D>& witness, Contact<D>& contact) {
  if (describe_plainly_touching(a, b, to_b, witness, options, contact)) return true;
  if (!touch(a, b, to_b, witness)) return false;
  witness.pair = pair_in_contact(a, b, to_b, witness);
  witness.state = PairCache<D>::touching;
  describe_contact<D>(a, b, to_b, witness, options, contact);
  return true;
}

}  // namespace halfspace
