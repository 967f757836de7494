#include <algorithm>
#include <tuple>

#include "world/share/block_record.h"
#include "world/snapshot.h"
#include "world/world.h"

// A world is assembled from records of its blocks, in ascending order of keys, so that its sums go in the
// same order as in the whole world. Settings, laws, clock and losses are those of the world that it comes
// from. The neighbour list in use stays in use: each block brings its entry, and the memory of its pairs.

namespace halfspace {

template <int D>
bool BlockRecord<D>::is_complete() const {
  std::size_t codes = 0;
  for (const PairRecord<D>& pair : pairs) {
    if (pair.plan_length < 0) return false;
    codes += std::size_t(pair.plan_length);
  }
  const auto follows = [](const PairRecord<D>& p, const PairRecord<D>& q) { return p.partner >= q.partner; };
  return codes == plans.size() && std::adjacent_find(pairs.begin(), pairs.end(), follows) == pairs.end() &&
         state.kind >= BlockKind::fixed && state.kind <= BlockKind::affine &&
         (!has_outline || outline.is_complete());
}

template <int D>
void World<D>::record(std::size_t slot, bool with_outline, BlockRecord<D>& out) {
  const Blocks<D>& blocks = model_.blocks;
  NeighborList<D>& neighbors = contacts_.neighbors();
  out.key = share_.key_of(slot);
  out.step = clock_.steps();
  out.version = snapshot::version;
  out.has_outline = with_outline;
  out.is_new = contacts_.is_new(slot);
  out.state = blocks.state_of(slot);
  std::tie(out.acceleration, out.momentum_rate) = integrator_.rates_of(slot);
  out.entry = neighbors.entry_of(slot);
  out.peaks = peaks();
  if (with_outline) blocks.copy_outline(std::int32_t(slot), out.outline);
  out.pairs.clear();
  out.plans.clear();
  if (slot >= neighbors.list_length() || !blocks.moves_freely(slot)) return;
  neighbors.index_pairs();
  neighbors.for_each_pair_of(std::int32_t(slot), [&](std::size_t k) {
    const Candidate<D>& pair = neighbors.pairs()[k];
    PairRecord<D> memory;
    memory.partner = share_.key_of(std::size_t(pair.a == std::int32_t(slot) ? pair.b : pair.a));
    memory.witness = pair.witness;
    memory.bonded = pair.bonded;
    memory.is_in_contact = contacts_.is_in_contact(k);
    if (!neighbors.shear().empty()) memory.shear = neighbors.shear()[k];
    if (memory.is_in_contact && forces_.are_known()) memory.force = forces_.of_pair(k);
    if constexpr (D == 3) {
      if (pair.plan.knows()) {
        const std::span<const PlanCode> plan = neighbors.plans()[pair.plan];
        memory.plan_length = std::int32_t(plan.size());
        out.plans.insert(out.plans.end(), plan.begin(), plan.end());
      }
    }
    out.pairs.push_back(memory);
  });
}

template <int D>
void World<D>::note_peaks(const Peaks& peaks) {
  peak_speed_ = std::max(peak_speed_, peaks.speed);
  contacts_.note_overlap(peaks.overlap);
  penetration_bound_.note(peaks.penetration_ratio);
}

template <int D>
std::int32_t World<D>::living_slot_of(std::int64_t key, std::size_t near) const {
  const std::int32_t slot = share_.slot_of(key, model_.blocks.slot_count(), near);
  return slot >= 0 && model_.blocks.lives(std::size_t(slot)) ? slot : -1;
}

/// Reads a block's record, or has the other world make it.
template <int D>
AssemblyFault::Kind World<D>::read_record(World<D>& from, const PackedBlock& block, std::int32_t known,
                                          BlockRecord<D>& out) {
  const bool is_known = known >= 0;
  if (block.bytes.empty()) {
    if (!is_known || from.share_.is_copy(std::size_t(known))) return AssemblyFault::unknown_block;
    from.record(std::size_t(known), false, out);
  } else {
    snapshot::Reader reader(block.bytes);
    reader(out);
    if (reader.failed() || !reader.at_end() || !out.is_complete() || out.key != block.key ||
        out.version != snapshot::version)
      return AssemblyFault::damaged_record;
    if (out.step != from.clock_.steps()) return AssemblyFault::other_step;
    if (!out.has_outline && !is_known) return AssemblyFault::unknown_outline;
    if (!is_known && !model_.blocks.is_sound(out.outline)) return AssemblyFault::damaged_record;
  }
  const bool is_everywhere = out.state.kind < BlockKind::rigid;
  return is_everywhere == (block.role == ShareRole::everywhere) ? AssemblyFault::none
                                                                : AssemblyFault::wrong_role;
}

template <int D>
Share::Common World<D>::common_of_shares() {
  if (!share_.is_whole()) return share_.common();
  const Blocks<D>& blocks = model_.blocks;
  std::size_t first = 0;
  while (first < blocks.slot_count() && !blocks.moves_freely(first)) ++first;
  return {blocks.count(), first < blocks.slot_count() ? share_.key_of(first) : -1,
          contacts_.neighbors().median_radius(blocks)};
}

/// All but the blocks and their pairs. Of a whole world, the share that owns its first free block takes the
/// losses.
template <int D>
void World<D>::take_settings(World<D>& from, std::span<const PackedBlock> blocks) {
  model_.settings = from.model_.settings;
  model_.materials = from.model_.materials;
  model_.water = from.model_.water;
  clock_ = from.clock_;
  strength_factor_ = from.strength_factor_;
  edited_ = from.edited_;
  note_peaks(from.peaks());
  const std::int64_t first = from.common_of_shares().first_key;
  const auto is_first = [&](const PackedBlock& block) {
    return block.key == first && block.role == ShareRole::own;
  };
  if (from.share_.has_losses_of_its_own() || std::any_of(blocks.begin(), blocks.end(), is_first))
    ledger_ = from.ledger_;
}

/// Adds the blocks in order, so that slot i is that of block i. A pair comes with the record of its first
/// block, or, where that is everywhere, with the other.
template <int D>
AssemblyFault World<D>::take_blocks(World<D>& from, std::span<const PackedBlock> blocks,
                                    CarriedPairs<D>& pairs) {
  const auto precedes = [](const PackedBlock& block, std::int64_t key) { return block.key < key; };
  const auto slot_of = [&](std::int64_t key) {
    const auto found = std::lower_bound(blocks.begin(), blocks.end(), key, precedes);
    return found != blocks.end() && found->key == key ? std::int32_t(found - blocks.begin()) : -1;
  };
  NeighborList<D>& neighbors = contacts_.neighbors();
  const bool is_listed = from.contacts_.neighbors().builds() > 0;
  const bool with_gradients = model_.materials.any_elastic();
  BlockRecord<D> record(model_.blocks.kind.get_allocator().resource());
  share_.reserve(blocks.size());
  integrator_.reserve(blocks.size());
  integrator_.resize(blocks.size());
  model_.blocks.begin_taking_over(from.model_.blocks, blocks.size());
  pairs.reserve(from.contacts_.neighbors().pairs().size() * blocks.size() /
                std::max<std::size_t>(1, from.model_.blocks.slot_count()));
  std::size_t last_known = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const PackedBlock& block = blocks[i];
    const std::int32_t known = from.living_slot_of(block.key, last_known), self = std::int32_t(i);
    if (known >= 0) last_known = std::size_t(known);
    const AssemblyFault::Kind fault = read_record(from, block, known, record);
    if (fault != AssemblyFault::none) return {fault, i};
    if (known >= 0) {
      model_.blocks.add(record.state, from.model_.blocks, known);
      if (!block.bytes.empty()) model_.blocks.renew_outline(self);
    } else {
      model_.blocks.add(record.state, record.outline);
    }
    note_peaks(record.peaks);
    share_.add(block.key, block.role);
    integrator_.set_rates(i, {record.acceleration, record.momentum_rate});
    if (is_listed) neighbors.add_entry(record.entry, with_gradients);
    contacts_.add_new_mark(record.is_new);
    std::size_t first_code = pairs.codes.size();
    pairs.codes.insert(pairs.codes.end(), record.plans.begin(), record.plans.end());
    for (const PairRecord<D>& pair : record.pairs) {
      const std::int32_t partner = slot_of(pair.partner);
      if (partner < 0) {
        ++pairs.missing[i];
      } else if (partner > self) {
        pairs.add({self, partner, pair, first_code});
      } else if (blocks[std::size_t(partner)].role == ShareRole::everywhere) {
        pairs.add_late({partner, self, pair, first_code});
      }
      first_code += std::size_t(pair.plan_length);
    }
  }
  model_.blocks.end_taking_over();
  pairs.put_in_order();
  return {};
}

template <int D>
void World<D>::take_pairs(const World<D>& from, const CarriedPairs<D>& pairs) {
  NeighborList<D>& neighbors = contacts_.neighbors();
  const bool with_shear =
      model_.materials.laws().any([](const ContactLaw& law) { return law.resists_shear(); });
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto& pair = pairs[k];
    const PairRecord<D>& memory = pair.memory;
    neighbors.add_pair({pair.a, pair.b, memory.witness, memory.bonded, {}}, memory.shear, with_shear);
  }
  neighbors.end_taking_over(from.contacts_.neighbors());
  share_.find_rings(neighbors.pairs());
  share_.note_missing(pairs.missing);
}

/// Motions and loads in time.
template <int D>
void World<D>::take_actions(const World<D>& from) {
  const auto key_of = [&](std::int32_t slot) { return from.share_.key_of(std::size_t(slot)); };
  const auto slot_of = [&](std::int64_t key) { return living_slot_of(key); };
  model_.actions.take_over(from.model_.actions, key_of, slot_of, share_.is_whole());
  if (!model_.actions.empty()) model_.actions.renew(model_.blocks);
}

/// Contacts, their forces and division plans.
template <int D>
void World<D>::take_contacts(const World<D>& from, const CarriedPairs<D>& pairs) {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (pairs[k].memory.is_in_contact && share_.loads(pairs[k])) contacts_.add_contact(k);
  }
  contacts_.end_taking_over(from.contacts_);
  fit_rooms();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    forces_.set_force(k, pairs[k].memory.force);
    if constexpr (D == 3) {
      NeighborList<D>& neighbors = contacts_.neighbors();
      const std::span<const PlanCode> plan = pairs.plan_of(pairs[k]);
      if (!plan.empty()) neighbors.plans().add(plan, neighbors.pairs()[k].plan);
    }
  }
  forces_.end_taking_over(from.forces_);
}

/// The loads on blocks that are everywhere are those that this share computes.
template <int D>
void World<D>::load_everywhere() {
  const Blocks<D>& blocks = model_.blocks;
  if (!forces_.are_known()) return;
  const auto is_everywhere = [&](std::int32_t slot) { return !blocks.moves_freely(std::size_t(slot)); };
  for (std::size_t i = 0; i < blocks.slot_count(); ++i)
    if (is_everywhere(std::int32_t(i))) forces_.set_load(i, Vector<D>::Zero(), Angular<D>::Zero());
  const auto add = [&](std::int32_t slot, const Vector<D>& force, const Angular<D>& torque) {
    const std::size_t i = std::size_t(slot);
    forces_.set_load(i, blocks.force[i] + force, blocks.torque[i] + torque);
  };
  for (std::size_t c = 0; c < contacts_.count(); ++c) {
    const Candidate<D>& pair = contacts_.pair_of(c);
    const ContactForce<D>& load = forces_.of_contact(c);
    const Vector<D> to_b = blocks.position[std::size_t(pair.b)] - blocks.position[std::size_t(pair.a)];
    if (is_everywhere(pair.a)) add(pair.a, -load.force, load.torque_on_a());
    if (is_everywhere(pair.b)) add(pair.b, load.force, load.torque_on_b(to_b));
  }
  const double unit_weight = model_.water.empty() ? 0 : model_.water.unit_weight(model_.settings.gravity);
  for (std::size_t i = 0; i < blocks.slot_count() && unit_weight != 0; ++i) {
    if (!blocks.moves(i) || blocks.moves_freely(i) || !share_.wets(i)) continue;
    const WaterLoad<D> water = model_.water.load_on(blocks, i, unit_weight);
    forces_.add_load(i, water.force, water.virial);
  }
}

template <int D>
AssemblyFault World<D>::assemble(World<D>& from, std::span<const PackedBlock> blocks) {
  take_settings(from, blocks);
  CarriedPairs<D> pairs(blocks.size(), model_.blocks.kind.get_allocator().resource());
  const AssemblyFault fault = take_blocks(from, blocks, pairs);
  if (fault.kind != AssemblyFault::none) return fault;
  share_.end_adding(from.common_of_shares());
  if (from.knows_potential() || !share_.is_whole()) model_.fixed_length = from.model_.potential_length();
  take_pairs(from, pairs);
  take_contacts(from, pairs);
  take_actions(from);
  load_everywhere();
  integrator_.look_what_moves();
  const auto was_sent = [](const PackedBlock& block) { return !block.bytes.empty(); };
  const bool is_trusted = std::none_of(blocks.begin(), blocks.end(), was_sent);
  const bool is_sound = is_trusted ? model_.actions.is_consistent(model_.blocks) : is_consistent();
  return {is_sound ? AssemblyFault::none : AssemblyFault::inconsistent_state, 0};
}

#define HALFSPACE_MEMBERS(D)                                                                               \
  template bool BlockRecord<D>::is_complete() const;                                                       \
  template void World<D>::record(std::size_t, bool, BlockRecord<D>&);                                      \
  template AssemblyFault::Kind World<D>::read_record(World<D>&, const PackedBlock&, std::int32_t,          \
                                                     BlockRecord<D>&);                                     \
  template std::int32_t World<D>::living_slot_of(std::int64_t, std::size_t) const;                         \
  template Share::Common World<D>::common_of_shares();                                                     \
  template void World<D>::note_peaks(const Peaks&);                                                        \
  template void World<D>::take_settings(World<D>&, std::span<const PackedBlock>);                          \
  template AssemblyFault World<D>::take_blocks(World<D>&, std::span<const PackedBlock>, CarriedPairs<D>&); \
  template void World<D>::take_pairs(const World<D>&, const CarriedPairs<D>&);                             \
  template void World<D>::take_contacts(const World<D>&, const CarriedPairs<D>&);                          \
  template void World<D>::take_actions(const World<D>&);                                                   \
  template void World<D>::load_everywhere();                                                               \
  template AssemblyFault World<D>::assemble(World<D>&, std::span<const PackedBlock>);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
