#include "narrow_phase/pair.h"

#include <cmath>

#include "geometry/tolerances.h"
#include "narrow_phase/plane/potential_pairs.h"

namespace halfspace {
namespace {

int edge_along(const Outline<2>& block, const Vector<2>& direction) {
  int most = 0;
  for (int edge = 1; edge < block.count; ++edge)
    if (block.normal(edge).dot(direction) > block.normal(most).dot(direction)) most = edge;
  return most;
}

bool are_in_line(const Vector<2>& one, const Vector<2>& other) {
  return std::abs(cross(one, other)) < strictly_parallel && one.dot(other) > 0;
}

}  // namespace

PotentialPair<2> pair_along(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                            const Vector<2>& normal) {
  PotentialPair<2> of_a{0, edge_along(a, normal), 0}, of_b{1, edge_along(b, -normal), 0};
  const double gap_of_a = refresh(a, b, to_b, of_a), gap_of_b = refresh(a, b, to_b, of_b);
  return gap_of_a >= gap_of_b ? of_a : of_b;
}

/// Parallel edges of both blocks are two pairs in one line: the walk continues over the second one.
PotentialPair<2> descend(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                         const PotentialPair<2>& start) {
  PotentialPair<2> best = start;
  double best_gap = refresh(a, b, to_b, best);
  const auto walk = [&](auto neighbour) {
    PotentialPair<2> last = best;
    for (int steps = a.count + b.count; steps > 0; --steps) {
      const Vector<2> normal = normal_of(a, b, last);
      last = neighbour(a, b, last);
      const double gap = refresh(a, b, to_b, last);
      if (gap > best_gap) {
        best = last;
        best_gap = gap;
      } else if (!are_in_line(normal, normal_of(a, b, last))) {
        break;
      }
    }
  };
  walk(next_pair);
  if (best.owner == start.owner && best.edge == start.edge) walk(previous_pair);
  return best;
}

}  // namespace halfspace
