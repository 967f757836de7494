#pragma once

#include "geometry/outline.h"
#include "narrow_phase/contact.h"
#include "narrow_phase/plane/separation.h"
#include "narrow_phase/space/pair.h"
#include "narrow_phase/space/separation.h"

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

/// Gap of the pair that keeps two blocks apart.
inline double refresh(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                      PairCache<2>& witness) {
  return refresh(a, b, to_b, witness.pair);
}

/// The pair through which blocks begin to meet that were separated at last (Wang et al. 2021, section 2.5).
inline PotentialPair<2> initial_pair(const Outline<2>&, const Outline<2>&, const Vector<2>&,
                                     const PairCache<2>& witness) {
  return witness.pair;
}

/// In the plane a search is as fast as a proof of contact.
inline bool still_touching(const Outline<2>&, const Outline<2>&, const Vector<2>&, PairCache<2>&) {
  return false;
}
inline bool describe_plainly_touching(const Outline<2>&, const Outline<2>&, const Vector<2>&,
                                      const PairCache<2>&, const DetectOptions&, Contact<2>&) {
  return false;
}
inline void remember_proof(const Contact<2>&, const Vector<2>&, PairCache<2>&) {}
inline void remember_point(const Vector<2>&, PairCache<2>&) {}

/// Unit normal of a potential pair's half-space, turned so that it points from a to b.
inline Vector<2> normal_of(const Outline<2>& a, const Outline<2>& b, const PotentialPair<2>& pair) {
  return pair.owner == 0 ? a.normal(pair.edge) : Vector<2>(-b.normal(pair.edge));
}

/// The less deep of the pairs whose faces look most along a normal from a to b, from either side.
PotentialPair<2> pair_along(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                            const Vector<2>& normal);

/// Walks around the Minkowski difference to the pair of least depth that is reached without passing a deeper
/// one. So the contact keeps the side through which the blocks met, also when a thin block is overlapped past
/// its middle.
PotentialPair<2> descend(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                         const PotentialPair<2>& start);

/// Type, normal, gap and region of the contact at a potential pair, touching or not. `pair` is moved to the
/// neighbouring one when the vertex has left the edge across its end.
void describe_contact(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, PotentialPair<2>& pair,
                      const DetectOptions& options, Contact<2>& contact);

inline PairCache<2> witness_of(const Separation<2>& separation) {
  return {PairCache<2>::separated, separation.pair};
}

// From here on the plane and space are alike. Outlines are in one orientation, each relative to its own
// centroid; `to_b` leads from that of a to that of b.

/// True when what is remembered still proves separation by itself (eqs. 12 and 31).
template <int D>
bool still_separated(const Outline<D>& a, const Outline<D>& b, const Vector<D>& to_b, PairCache<D>& witness) {
  return witness.state == PairCache<D>::separated && refresh(a, b, to_b, witness) > 0;
}

/// The pair through which blocks meet that are found to overlap: the one through which they begin to, or
/// what a walk from there reaches that is less deep; the one remembered when they touched before; without
/// history the given one, of least depth (section 2.5). Remembers it, with its vertex brought up to date.
template <int D>
void remember_contact(const Seen<D>& a, const Seen<D>& b, const Vector<D>& to_b,
                      const PotentialPair<D>& least_depth, PairCache<D>& witness) {
  if (witness.state == PairCache<D>::separated) {
    witness.pair = descend(a, b, to_b, initial_pair(a, b, to_b, witness));
  } else {
    if (witness.state != PairCache<D>::touching) witness.pair = least_depth;
    refresh(a, b, to_b, witness.pair);
  }
  witness.state = PairCache<D>::touching;
}

/// Type, normal, gap and region of the contact at the remembered pair. In space, a point of both blocks is
/// remembered as well, by which the next step may know sooner that they are still in contact.
template <int D>
void describe_contact(const Seen<D>& a, const Seen<D>& b, const Vector<D>& to_b, PairCache<D>& witness,
                      const DetectOptions& options, Contact<D>& contact) {
  describe_contact(a, b, to_b, witness.pair, options, contact);
  if (witness.state == PairCache<D>::touching) remember_proof(contact, to_b, witness);
}

/// Describes the contact of two blocks that overlap.
template <int D>
void describe_overlap(const Seen<D>& a, const Seen<D>& b, const Vector<D>& to_b,
                      const PotentialPair<D>& least_depth, const DetectOptions& options,
                      PairCache<D>& witness, Contact<D>& contact) {
  remember_contact(a, b, to_b, least_depth, witness);
  describe_contact(a, b, to_b, witness, options, contact);
}

/// Judges all potential pairs of two blocks, unless they are known still to touch, and remembers the contact
/// or the separation.
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

/// True when two blocks touch.
template <int D>
bool touch(const Outline<D>& a, const Outline<D>& b, const Vector<D>& to_b, PairCache<D>& witness) {
  if (!still_separated(a, b, to_b, witness)) judge_pair(a, b, to_b, witness);
  return touching(witness);
}

/// The pair through which blocks that touch do so: the remembered one, or that of least depth.
template <int D>
PotentialPair<D> pair_in_contact(const Outline<D>& a, const Outline<D>& b, const Vector<D>& to_b,
                                 const PairCache<D>& witness) {
  if (witness.state != PairCache<D>::overlapping) return witness.pair;
  const Separation<D> separation = find_separation(a, b, to_b);
  // To rounding they may be apart.
  return separation.gap > 0 ? initial_pair(a, b, to_b, witness_of(separation)) : separation.pair;
}

/// True when two blocks touch; then their contact is described. The same as to judge the pair and to describe
/// the contact after that, but that a contact which has hardly changed is known to be one by its description.
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
