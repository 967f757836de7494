#include <algorithm>

#include "force/potential/space/planned_force.h"
#include "geometry/numbers.h"
#include "world/neighbor_list.h"

// A neighbour list of a snapshot is checked, so that no index leads out of an array.

namespace halfspace {
namespace {

bool is_below(std::int32_t index, std::int32_t count) { return index >= 0 && index < count; }

bool names_features(const PotentialPair<2>& pair, const Outline<2>& a, const Outline<2>& b) {
  if (pair.owner != 0 && pair.owner != 1) return false;
  return is_below(pair.edge, (pair.owner == 0 ? a : b).count) &&
         is_below(pair.vertex, (pair.owner == 0 ? b : a).count);
}

bool names_features(const PotentialPair<3>& pair, const Outline<3>& a, const Outline<3>& b) {
  using Pair = PotentialPair<3>;
  const Topology &of_a = *a.topology, &of_b = *b.topology;
  switch (pair.kind) {
    case Pair::face_vertex:
      return is_below(pair.a, of_a.face_count) && is_below(pair.b, of_b.vertex_count);
    case Pair::vertex_face:
      return is_below(pair.a, of_a.vertex_count) && is_below(pair.b, of_b.face_count);
    case Pair::edge_edge:
      return is_below(pair.a, of_a.edge_count) && is_below(pair.b, of_b.edge_count);
    case Pair::vertex_vertex:
      return is_below(pair.a, of_a.vertex_count) && is_below(pair.b, of_b.vertex_count);
  }
  return false;
}

bool knows_its_plan(const Candidate<2>&, const DivisionPlans&, const Outline<2>&, const Outline<2>&) {
  return true;
}
bool knows_its_plan(const Candidate<3>& pair, const DivisionPlans& plans, const Outline<3>& a,
                    const Outline<3>& b) {
  return !pair.plan.knows() || is_plan(plans[pair.plan], a, b);
}

}  // namespace

template <int D>
bool NeighborList<D>::is_consistent(const Blocks<D>& blocks) const {
  const std::size_t slots = blocks.slot_count();
  const std::size_t listed = list_length();
  if (listed > slots || planned_.size() != listed || calm_motion_.size() != listed ||
      (!used_up_ && listed != slots))
    return false;
  if (reference_position_.size() != listed || reference_rotation_.size() != listed) return false;
  if (!shear_.empty() && shear_.size() != pairs_.size()) return false;
  if constexpr (D == 3) {
    if (!plans_.are_of(pairs_)) return false;
  }
  if (!reference_gradient_.empty() && reference_gradient_.size() > slots) return false;
  const auto lives = [&](std::int32_t slot) {
    return slot >= 0 && std::size_t(slot) < slots && blocks.lives(std::size_t(slot));
  };
  const auto follows = [](const Candidate<D>& p, const Candidate<D>& q) {
    return p.a > q.a || (p.a == q.a && p.b >= q.b);
  };
  if (std::adjacent_find(pairs_.begin(), pairs_.end(), follows) != pairs_.end()) return false;
  return all(pairs_, [&](const Candidate<D>& pair) {
    if (!lives(pair.a) || !lives(pair.b) || pair.a >= pair.b) return false;
    const PairMemory<D>& memory = pair.memory;
    constexpr auto last = D == 2 ? PairMemory<D>::touching : PairMemory<D>::overlapping;
    if (memory.state < PairMemory<D>::unknown || memory.state > last) return false;
    if (!knows_its_plan(pair, plans_, blocks.outline(pair.a), blocks.outline(pair.b))) return false;
    const bool separated = memory.state == PairMemory<D>::separated;
    return (separated || has_a_plane(memory.pair)) &&
           names_features(memory.pair, blocks.outline(pair.a), blocks.outline(pair.b));
  });
}

template bool NeighborList<2>::is_consistent(const Blocks<2>&) const;
template bool NeighborList<3>::is_consistent(const Blocks<3>&) const;

}  // namespace halfspace
