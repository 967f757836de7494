#include "detect/pair.h"

#include "detect/potential_pairs.h"

namespace halfspace {
namespace {

/// Walks around the Minkowski difference to the pair of least depth that is reached without passing a deeper one. So the
/// contact keeps the side through which the blocks met, also when a thin block is overlapped past its middle.
Separation descend(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, Separation from) {
  const auto walk = [&](auto neighbour) {
    const PotentialPair start = from.pair;
    for (int steps = a.count + b.count; steps > 0; --steps) {
      Separation candidate{0, neighbour(a, b, from.pair)};
      candidate.gap = refresh(a, b, to_b, candidate.pair);
      if (candidate.gap <= from.gap) break;
      from = candidate;
    }
    return !(from.pair == start);
  };
  if (!walk(next_pair)) walk(previous_pair);
  return from;
}

}  // namespace

double refresh(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, PotentialPair& pair) {
  const bool a_owns = pair.owner == 0;
  const Outline<2>& owner = a_owns ? a : b;
  const Outline<2>& other = a_owns ? b : a;
  pair.vertex = deepest_vertex(other, owner.normal(pair.edge), pair.vertex);
  return edge_gap(owner, pair.edge, other, pair.vertex, a_owns ? to_b : -to_b);
}

Separation judge(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, PairMemory& memory) {
  if (memory.state == PairMemory::separated) {
    const double gap = refresh(a, b, to_b, memory.pair);
    if (gap > 0) return {gap, memory.pair};
  }
  Separation separation = find_separation(a, b, to_b);
  if (separation.gap > 0) {
    memory = {PairMemory::separated, separation.pair};
    return separation;
  }
  if (memory.state == PairMemory::unknown) {
    memory.pair = separation.pair;  // no history: the least depth stands in
  } else {
    separation.pair = memory.pair;
    separation.gap = refresh(a, b, to_b, separation.pair);
    if (memory.state == PairMemory::separated) separation = descend(a, b, to_b, separation);
    memory.pair = separation.pair;
  }
  memory.state = PairMemory::touching;
  return separation;
}

void detect_pair(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b, const DetectOptions& options,
                 PairMemory& memory, Contact<2>& contact) {
  const Separation separation = judge(a, b, to_b, memory);
  if (separation.gap <= 0) {
    describe_contact(a, b, to_b, memory.pair, options, contact);
    return;
  }
  contact.type = ContactType::none;
  contact.pair = separation.pair;
  contact.point_count = 0;
  contact.gap = separation.gap;
  contact.length = 0;
  contact.normal =
      separation.pair.owner == 0 ? a.normal(separation.pair.edge) : Vector<2>(-b.normal(separation.pair.edge));
}

}  // namespace halfspace
