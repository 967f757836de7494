#include <algorithm>
#include <cmath>

#include "force/planned_force.h"
#include "world/world.h"

// What a snapshot must fulfil so that running it never leads out of an array. Numbers may be wrong in value:
// that is what the checksum is for; here the question is what a wrong index could do.

namespace halfspace {

bool LawTable::is_consistent() const {
  const std::size_t materials = std::size_t(material_count_);
  const auto names_a_law = [&](std::int32_t index) {
    return index >= -1 && index < std::int64_t(own_.size());
  };
  return material_count_ >= 0 && law_of_pair_.size() == materials * (materials + 1) / 2 &&
         std::all_of(law_of_pair_.begin(), law_of_pair_.end(), names_a_law);
}

template <int D>
bool Blocks<D>::is_consistent(std::int32_t material_count) const {
  const std::size_t slots = slot_count();
  const std::size_t sizes[] = {
      material.size(), generation.size(), position.size(),      velocity.size(),
      force.size(),    rotation.size(),   applied_force.size(), spin.size(),
      momentum.size(), torque.size(),     mass.size(),          applied_torque.size(),
      inertia.size(),  radius.size(),     largest_face.size(),  outlines_.slot_count()};
  if (std::any_of(std::begin(sizes), std::end(sizes), [&](std::size_t size) { return size != slots; }))
    return false;
  if (angle.size() != (D == 2 ? slots : 0)) return false;
  Array<std::int32_t> living(kind.get_allocator().resource());
  for (std::size_t i = 0; i < slots; ++i) {
    if (kind[i] == BlockKind::none) continue;
    living.push_back(std::int32_t(i));
    if (kind[i] < BlockKind::fixed || kind[i] > BlockKind::affine) return false;
    if (material[i] < 0 || material[i] >= material_count) return false;
  }
  const auto is_free = [&](std::int32_t slot) {
    return slot >= 0 && std::size_t(slot) < slots && !lives(std::size_t(slot));
  };
  return std::int64_t(living.size()) == living_ && free_slots_.size() == slots - living.size() &&
         std::all_of(free_slots_.begin(), free_slots_.end(), is_free) && outlines_.is_consistent(living) &&
         deformations_.is_consistent(slots, [&](std::size_t slot) { return is_affine(slot); });
}

namespace {

bool is_below(std::int32_t index, std::int32_t count) { return index >= 0 && index < count; }

bool names_features(const PotentialPair<2>& pair, const Outline<2>& a, const Outline<2>& b) {
  if (pair.owner != 0 && pair.owner != 1) return false;
  return is_below(pair.edge, (pair.owner == 0 ? a : b).count) &&
         is_below(pair.vertex, (pair.owner == 0 ? b : a).count);
}

/// Two vertices may keep blocks apart, but no contact is described by them.
bool has_a_plane(const PotentialPair<2>&) { return true; }
bool has_a_plane(const PotentialPair<3>& pair) { return pair.kind != PotentialPair<3>::vertex_vertex; }

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
  return !pair.plan.knows() || (plans.has(pair.plan) && is_plan(plans[pair.plan], a, b));
}

}  // namespace

template <int D>
bool Candidates<D>::is_consistent(const Blocks<D>& blocks) const {
  const std::size_t slots = blocks.slot_count();
  const std::size_t listed = skin_.size();
  if (listed > slots || planned_.size() != listed || (!used_up_ && listed != slots)) return false;
  if (reference_position_.size() != listed || reference_rotation_.size() != listed) return false;
  if (!shear_.empty() && shear_.size() != pairs_.size()) return false;
  if (!plans_.is_consistent()) return false;
  if (!reference_gradient_.empty() && reference_gradient_.size() > slots) return false;
  const auto lives = [&](std::int32_t slot) {
    return slot >= 0 && std::size_t(slot) < slots && blocks.lives(std::size_t(slot));
  };
  return std::all_of(pairs_.begin(), pairs_.end(), [&](const Candidate<D>& pair) {
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

template <int D>
bool World<D>::is_consistent() const {
  if (!laws_.is_consistent() || laws_.material_count() != material_count()) return false;
  if (elasticity_.size() != density_.size()) return false;
  if (!blocks_.is_consistent(material_count()) || !candidates_.is_consistent(blocks_)) return false;
  const std::size_t slots = blocks_.slot_count();
  if (fresh_.size() > slots || (any_fresh_ && fresh_.size() != slots)) return false;
  if (!edited_ && (acceleration_.size() != slots || momentum_rate_.size() != slots)) return false;
  if (acceleration_.size() > slots || momentum_rate_.size() > slots) return false;
  if (!forces_.empty() && forces_.size() != touching_.size()) return false;
  if (!(time_step_ >= 0) || !std::isfinite(time_step_)) return false;
  if (epoch_step_ < 0 || steps_ < epoch_step_) return false;
  const auto names_a_pair = [&](std::uint32_t candidate) {
    const Array<Candidate<D>>& pairs = candidates_.pairs();
    return candidate < pairs.size() && has_a_plane(pairs[candidate].memory.pair);
  };
  return std::all_of(touching_.begin(), touching_.end(), names_a_pair);
}

template bool Blocks<2>::is_consistent(std::int32_t) const;
template bool Blocks<3>::is_consistent(std::int32_t) const;
template bool Candidates<2>::is_consistent(const Blocks<2>&) const;
template bool Candidates<3>::is_consistent(const Blocks<3>&) const;
template bool World<2>::is_consistent() const;
template bool World<3>::is_consistent() const;

}  // namespace halfspace
