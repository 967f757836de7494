#include "narrow_phase/pair.h"

#include "narrow_phase/plane/potential_pairs.h"

namespace halfspace {

PotentialPair<2> descend(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                         const PotentialPair<2>& start) {
  PotentialPair<2> best = start;
  double best_gap = refresh(a, b, to_b, best);
  const auto walk = [&](auto neighbour) {
    for (int steps = a.count + b.count; steps > 0; --steps) {
      PotentialPair<2> candidate = neighbour(a, b, best);
      const double gap = refresh(a, b, to_b, candidate);
      if (gap <= best_gap) break;
      best = candidate;
      best_gap = gap;
    }
  };
  walk(next_pair);
  if (best.owner == start.owner && best.edge == start.edge) walk(previous_pair);
  return best;
}

}  // namespace halfspace
