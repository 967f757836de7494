#include "narrow_phase/plane/potential_pairs.h"

namespace halfspace {

PotentialPair<2> next_pair(const Outline<2>& a, const Outline<2>& b, const PotentialPair<2>& pair) {
  const Outline<2>& owner = pair.owner == 0 ? a : b;
  const Outline<2>& other = pair.owner == 0 ? b : a;
  const int next_edge = owner.next(pair.edge);
  const bool owner_comes_first = cross(owner.normal(next_edge), -other.normal(pair.vertex)) >= 0;
  if (owner_comes_first) return {pair.owner, next_edge, pair.vertex};
  return {1 - pair.owner, pair.vertex, next_edge};
}

PotentialPair<2> previous_pair(const Outline<2>& a, const Outline<2>& b, const PotentialPair<2>& pair) {
  const Outline<2>& owner = pair.owner == 0 ? a : b;
  const Outline<2>& other = pair.owner == 0 ? b : a;
  const int previous_edge = owner.previous(pair.edge);
  const int edge_before_vertex = other.previous(pair.vertex);
  const bool owner_comes_first = cross(owner.normal(previous_edge), -other.normal(edge_before_vertex)) <= 0;
  if (owner_comes_first) return {pair.owner, previous_edge, pair.vertex};
  return {1 - pair.owner, edge_before_vertex, pair.edge};
}

}  // namespace halfspace
