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

namespace {

/// A pair of the world to be assembled, with the place of its division plan.
template <int D>
struct CarriedPair {
  std::int32_t a;
  std::int32_t b;
  PairRecord<D> memory;
  std::size_t first_code;
};

}  // namespace

template <int D>
void World<D>::record(std::size_t slot, bool with_outline, BlockRecord<D>& out) {
  const Blocks<D>& blocks = model_.blocks;
  NeighborList<D>& neighbors = contacts_.neighbors();
  out.key = share_.key_of(slot);
  out.has_outline = with_outline;
  out.is_new = contacts_.is_new(slot);
  out.state = blocks.state_of(slot);
  std::tie(out.acceleration, out.momentum_rate) = integrator_.rates_of(slot);
  out.entry = neighbors.entry_of(slot);
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
std::int32_t World<D>::living_slot_of(std::int64_t key) const {
  const std::int32_t slot = share_.slot_of(key, model_.blocks.slot_count());
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
    if (reader.failed() || !reader.at_end() || !out.is_complete() || out.key != block.key)
      return AssemblyFault::damaged_record;
    if (!out.has_outline && !is_known) return AssemblyFault::unknown_outline;
    if (!is_known && !model_.blocks.is_sound(out.outline)) return AssemblyFault::damaged_record;
  }
  const bool is_everywhere = out.state.kind < BlockKind::rigid;
  return is_everywhere == (block.role == ShareRole::everywhere) ? AssemblyFault::none
                                                                : AssemblyFault::wrong_role;
}

/// All but the blocks and their pairs. Losses go to the share that owns the first free block of a whole
/// world.
template <int D>
void World<D>::take_settings(const World<D>& from, std::span<const PackedBlock> blocks) {
  model_.settings = from.model_.settings;
  model_.materials = from.model_.materials;
  model_.water = from.model_.water;
  if (from.knows_potential()) model_.fixed_length = from.model_.potential_length();
  clock_ = from.clock_;
  peak_speed_ = from.peak_speed_;
  strength_factor_ = from.strength_factor_;
  edited_ = from.edited_;
  penetration_bound_.note(from.penetration_bound_.noted());
  if (!from.share_.is_whole()) {
    ledger_ = from.ledger_;
    return;
  }
  const Blocks<D>& all = from.model_.blocks;
  const auto is_first = [&](const PackedBlock& block) {
    std::size_t first = 0;
    while (first < all.slot_count() && !all.moves_freely(first)) ++first;
    return block.role == ShareRole::own && first < all.slot_count() && block.key == from.share_.key_of(first);
  };
  const auto own = std::find_if(blocks.begin(), blocks.end(),
                                [](const PackedBlock& block) { return block.role == ShareRole::own; });
  if (own != blocks.end() && is_first(*own)) ledger_ = from.ledger_;
}

template <int D>
AssemblyFault World<D>::assemble(World<D>& from, std::span<const PackedBlock> blocks) {
  take_settings(from, blocks);
  Memory* const memory = model_.blocks.kind.get_allocator().resource();
  NeighborList<D>& neighbors = contacts_.neighbors();
  const LawTable& laws = model_.materials.laws();
  const bool with_shear = laws.any([](const ContactLaw& law) { return law.resists_shear(); });
  const bool with_gradients = from.contacts_.neighbors().has_gradients();
  const bool is_listed = from.contacts_.neighbors().list_length() > 0;

  const auto slot_of = [&](std::int64_t key) {
    const auto found =
        std::lower_bound(blocks.begin(), blocks.end(), key,
                         [](const PackedBlock& block, std::int64_t k) { return block.key < k; });
    return found != blocks.end() && found->key == key ? std::int32_t(found - blocks.begin()) : -1;
  };
  BlockRecord<D> record(memory);
  Array<CarriedPair<D>> carried(memory);
  Array<PlanCode> codes(memory);
  Array<std::int32_t> missing(blocks.size(), 0, memory);
  bool was_sent = false;
  share_.reserve(blocks.size());
  integrator_.reserve(blocks.size());
  integrator_.resize(blocks.size());
  model_.blocks.begin_taking_over(from.model_.blocks);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const PackedBlock& block = blocks[i];
    const std::int32_t known = from.living_slot_of(block.key);
    const AssemblyFault::Kind fault = read_record(from, block, known, record);
    if (fault != AssemblyFault::none) return {fault, i};
    was_sent = was_sent || !block.bytes.empty();
    if (known >= 0) {
      model_.blocks.add(record.state, from.model_.blocks, known);
      if (!block.bytes.empty()) model_.blocks.renew_outline(std::int32_t(i));
    } else {
      model_.blocks.add(record.state, record.outline);
    }
    share_.add(block.key, block.role);
    integrator_.set_rates(i, {record.acceleration, record.momentum_rate});
    if (is_listed) neighbors.add_entry(record.entry, with_gradients);
    contacts_.add_new_mark(record.is_new);
    std::size_t first_code = codes.size();
    codes.insert(codes.end(), record.plans.begin(), record.plans.end());
    for (const PairRecord<D>& pair : record.pairs) {
      const std::int32_t self = std::int32_t(i), partner = slot_of(pair.partner);
      if (partner < 0) {
        ++missing[i];
      } else if (partner > self || blocks[std::size_t(partner)].role == ShareRole::everywhere) {
        carried.push_back({std::min(self, partner), std::max(self, partner), pair, first_code});
      }
      first_code += std::size_t(pair.plan_length);
    }
  }
  model_.blocks.end_taking_over();
  std::sort(carried.begin(), carried.end(), [](const CarriedPair<D>& p, const CarriedPair<D>& q) {
    return std::tie(p.a, p.b) < std::tie(q.a, q.b);
  });
  for (const CarriedPair<D>& pair : carried)
    neighbors.add_pair(Candidate<D>{pair.a, pair.b, pair.memory.witness, pair.memory.bonded, {}},
                       pair.memory.shear, with_shear);
  neighbors.end_taking_over(from.contacts_.neighbors());
  share_.end_adding(from.share_.is_whole() ? from.model_.blocks.count() : from.share_.blocks_in_all(),
                    from.share_.is_whole() ? from.contacts_.neighbors().median_radius(from.model_.blocks)
                                           : from.share_.typical_radius());
  share_.find_rings(neighbors.pairs());
  share_.note_missing(missing);

  for (std::size_t k = 0; k < carried.size(); ++k) {
    if (carried[k].memory.is_in_contact && share_.loads(neighbors.pairs()[k])) contacts_.add_contact(k);
  }
  contacts_.end_taking_over(from.contacts_);
  fit_rooms();
  for (std::size_t k = 0; k < carried.size(); ++k) {
    forces_.set_force(k, carried[k].memory.force);
    if constexpr (D == 3) {
      const PairRecord<D>& pair = carried[k].memory;
      if (pair.plan_length > 0)
        neighbors.plans().add({codes.data() + carried[k].first_code, std::size_t(pair.plan_length)},
                              neighbors.pairs()[k].plan);
    }
  }
  forces_.end_taking_over(from.forces_);
  integrator_.look_what_moves();
  if (was_sent && !is_consistent()) return {AssemblyFault::inconsistent_state, 0};
  return {};
}

#define HALFSPACE_MEMBERS(D)                                                                      \
  template bool BlockRecord<D>::is_complete() const;                                              \
  template void World<D>::record(std::size_t, bool, BlockRecord<D>&);                             \
  template AssemblyFault::Kind World<D>::read_record(World<D>&, const PackedBlock&, std::int32_t, \
                                                     BlockRecord<D>&);                            \
  template std::int32_t World<D>::living_slot_of(std::int64_t) const;                             \
  template void World<D>::take_settings(const World<D>&, std::span<const PackedBlock>);           \
  template AssemblyFault World<D>::assemble(World<D>&, std::span<const PackedBlock>);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
