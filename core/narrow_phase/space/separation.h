#pragma once

#include "geometry/outline.h"
#include "narrow_phase/contact.h"
#include "narrow_phase/space/gjk_epa.h"
#include "narrow_phase/space/turned_outline.h"

namespace halfspace {

/// True for blocks of few features, where testing all potential pairs is faster than a descent
/// (tests/benchmarks, bench_pairs_3d).
bool by_all_combinations(const Outline<3>& a, const Outline<3>& b);

/// The largest of all gaps, or the first found above the margin: vertex-face pairs first, edge-edge pairs
/// only if none of those is violated (Wang et al. 2021, eqs. 31-35). Both blocks are in one orientation.
Separation<3> find_separation_by_all(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                     double margin = 0);

/// A violated potential pair or a plane between the blocks, or the potential pair of minimum depth, by the
/// faster method.
inline Separation<3> find_separation(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b) {
  return by_all_combinations(a, b)
             ? find_separation_by_all(a, b, to_b)
             : find_separation_by_descent(MinkowskiDifference<NoTurn>(a, b, to_b, NoTurn()));
}

/// The potential pair of largest gap, also when several are violated; for blocks of many features the largest
/// gap found by a walk, or a plane with a larger gap.
Separation<3> find_largest_separation(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b);

/// find_separation() for blocks in their own frames; `b_in_a` rotates from the frame of b to that of a. The
/// result is in the frame of a.
inline Separation<3> find_separation(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                     const Rotation<3>& b_in_a) {
  return by_all_combinations(a, b)
             ? find_separation_by_all(a, TurnedPolyhedron(b, b_in_a).outline(), to_b)
             : find_separation_by_descent(MinkowskiDifference<Rotation<3>>(a, b, to_b, b_in_a));
}

}  // namespace halfspace
