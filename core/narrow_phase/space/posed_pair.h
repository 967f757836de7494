#pragma once

#include "narrow_phase/pair.h"
#include "narrow_phase/posed_pair.h"
#include "narrow_phase/space/minkowski_difference.h"

namespace halfspace {

/// The gap between the blocks along a unit vector from a to b, in the frame of a.
inline double gap_along(const Vector<3>& normal, const Outline<3>& a, const Outline<3>& b,
                        const Frames<3>& frames) {
  const MinkowskiDifference<Rotation<3>> difference(a, b, frames.to_b, frames.b_in_a);
  return normal.dot(difference.deepest_along(normal).at);
}

inline Contact<3> separated(const Separation<3>& found) {
  return contact_without_region<3>(ContactType::none, found.pair, found.normal, found.gap);
}

/// Searches a pair of polyhedra, as plane/posed_pair.h does for polygons.
[[gnu::always_inline]] inline Contact<3> search_pair(const PosedPair<3>& posed, const Frames<3>& frames,
                                                     const PairOptions& options, PairCache<3>& witness,
                                                     Memory*) {
  const Outline<3>&a = posed.a.outline(), &b = posed.b.outline();
  if (witness.state == PairCache<3>::separated) {
    // The cached plane may still separate the blocks, though motion has invalidated the host's proof.
    const Vector<3> normal = witness.proof, seen_from_a = frames.of_a.inverse() * normal;
    const double gap = gap_along(seen_from_a, a, b, frames);
    if (gap > 0) return separated({gap, witness.pair, normal});
    witness.proof = seen_from_a;
  }
  Separation<3> found = find_separation(a, b, frames.to_b, frames.b_in_a);
  if (found.gap > 0) {
    found.normal = frames.of_a * found.normal;
    witness = witness_of(found);
    return separated(found);
  }
  Contact<3> contact;
  describe_overlap<3>(a, {b, frames.b_in_a}, frames.to_b, found.pair, options, witness, contact);
  place(contact, frames.of_a, Vector<3>(posed.at_a.position));
  return contact;
}

}  // namespace halfspace
