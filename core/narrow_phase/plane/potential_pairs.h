#pragma once

#include "geometry/outline.h"
#include "narrow_phase/contact.h"
#include "narrow_phase/plane/separation.h"

namespace halfspace {

/// Visits every vertex-edge potential contact pair of two blocks (Wang et al. 2021, eq. 9) by one merge of
/// their edge normals, which are sorted by angle: O(n + m). The visitor returns false to stop.
///
/// The pairs are the edges of the Minkowski difference a - b, counter-clockwise: at each normal of a, the
/// deepest vertex of b is the one reached in the merge with b's opposed normals, and vice versa.
template <class Visitor>
void for_each_potential_pair(const Outline<2>& a, const Outline<2>& b, Visitor&& visit) {
  int i = 0;
  int j = deepest_vertex(b, a.normal(0));
  for (int seen_of_a = 0, seen_of_b = 0; seen_of_a < a.count || seen_of_b < b.count;) {
    // Vertex j stays the deepest until b's opposed edge j comes between a's last normal and its next.
    const bool a_comes_first =
        seen_of_b == b.count || (seen_of_a < a.count && cross(a.normal(i), -b.normal(j)) >= 0);
    if (a_comes_first) {
      if (!visit(PotentialPair<2>{0, i, j})) return;
      i = a.next(i);
      ++seen_of_a;
    } else {
      if (!visit(PotentialPair<2>{1, j, i})) return;
      j = b.next(j);
      ++seen_of_b;
    }
  }
}

/// The potential pair that follows (or precedes) another around the Minkowski difference, across that end of
/// its edge.
PotentialPair<2> next_pair(const Outline<2>& a, const Outline<2>& b, const PotentialPair<2>& pair);
PotentialPair<2> previous_pair(const Outline<2>& a, const Outline<2>& b, const PotentialPair<2>& pair);

}  // namespace halfspace
