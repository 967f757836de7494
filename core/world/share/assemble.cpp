#include <algorithm>
#include <tuple>

#include "world/share/assembly.h"
#include "world/share/block_record.h"
#include "world/share/shared_world.h"
#include "world/snapshot.h"

// A world is assembled from records of its blocks, in ascending order of keys, so that its sums go in the
// same order as in the whole world. Settings, laws, clock and losses are those of the world that it comes
// from. The neighbour list in use stays in use: each block brings its entry, and the memory of its pairs.

namespace halfspace {
namespace {

template <int D>
Peaks peaks_of(const State<D>& state) {
  return {state.peak_speed, state.contacts.peak_overlap(), state.penetration_bound.noted()};
}

}  // namespace

template <int D>
bool BlockRecord<D>::is_complete() const {
  const auto follows = [](const PairRecord<D>& p, const PairRecord<D>& q) { return p.partner >= q.partner; };
  return std::adjacent_find(pairs.begin(), pairs.end(), follows) == pairs.end() &&
         state.kind >= BlockKind::fixed && state.kind <= BlockKind::affine &&
         (!has_outline || outline.is_complete());
}

template <int D>
void write_record(State<D>& from, std::size_t slot, bool with_outline, BlockRecord<D>& out) {
  const Blocks<D>& blocks = from.model.blocks;
  NeighborList<D>& neighbors = from.contacts.neighbors();
  out.key = from.share.key_of(slot);
  out.step = from.clock.steps();
  out.version = snapshot::version;
  out.has_outline = with_outline;
  out.is_new = from.contacts.is_new(slot);
  out.state = blocks.state_of(slot);
  std::tie(out.acceleration, out.momentum_rate) = from.integrator.rates_of(slot);
  out.entry = neighbors.entry_of(slot);
  out.peaks = peaks_of(from);
  if (with_outline) blocks.copy_outline(std::int32_t(slot), out.outline);
  out.pairs.clear();
  if (slot >= neighbors.list_length() || !blocks.moves_freely(slot)) return;
  neighbors.index_pairs();
  neighbors.for_each_pair_of(std::int32_t(slot), [&](std::size_t k) {
    const Candidate<D>& pair = neighbors.pairs()[k];
    PairRecord<D> memory;
    memory.partner = from.share.key_of(std::size_t(pair.a == std::int32_t(slot) ? pair.b : pair.a));
    memory.witness = pair.witness;
    memory.bonded = pair.bonded;
    memory.is_in_contact = from.contacts.is_in_contact(k);
    if (!neighbors.shear().empty()) memory.shear = neighbors.shear()[k];
    if (memory.is_in_contact && from.forces.are_known()) memory.force = from.forces.of_pair(k);
    out.pairs.push_back(memory);
  });
}

namespace {

/// Makes a new and empty world one of given blocks of another.
template <int D>
class Assembly {
 public:
  Assembly(World<D>& to, World<D>& from, std::size_t blocks)
      : to_(to.state()), stages_(to.stages()), from_(from.state()), pairs_(blocks, to_.memory()) {}

  AssemblyFault assemble(std::span<const PackedBlock> blocks);

 private:
  void note_peaks(const Peaks& peaks);
  AssemblyFault::Kind read_record(const PackedBlock& block, std::int32_t known, BlockRecord<D>& out);
  void take_settings(std::span<const PackedBlock> blocks);
  AssemblyFault take_blocks(std::span<const PackedBlock> blocks);
  void take_pairs();
  void take_actions();
  void take_contacts();
  void load_everywhere();

  State<D>& to_;
  Stages<D>& stages_;
  State<D>& from_;
  CarriedPairs<D> pairs_;
};

template <int D>
void Assembly<D>::note_peaks(const Peaks& peaks) {
  to_.peak_speed = std::max(to_.peak_speed, peaks.speed);
  to_.contacts.note_overlap(peaks.overlap);
  to_.penetration_bound.note(peaks.penetration_ratio);
}

/// Reads a block's record, or has the other world make it.
template <int D>
AssemblyFault::Kind Assembly<D>::read_record(const PackedBlock& block, std::int32_t known,
                                             BlockRecord<D>& out) {
  const bool is_known = known >= 0;
  if (block.bytes.empty()) {
    if (!is_known || from_.share.is_copy(std::size_t(known))) return AssemblyFault::unknown_block;
    write_record(from_, std::size_t(known), false, out);
  } else {
    snapshot::Reader reader(block.bytes);
    reader(out);
    if (reader.failed() || !reader.at_end() || !out.is_complete() || out.key != block.key ||
        out.version != snapshot::version)
      return AssemblyFault::damaged_record;
    if (out.step != from_.clock.steps()) return AssemblyFault::other_step;
    if (!out.has_outline && !is_known) return AssemblyFault::unknown_outline;
    if (!is_known && !to_.model.blocks.is_sound(out.outline)) return AssemblyFault::damaged_record;
  }
  const bool is_everywhere = out.state.kind < BlockKind::rigid;
  return is_everywhere == (block.role == ShareRole::everywhere) ? AssemblyFault::none
                                                                : AssemblyFault::wrong_role;
}

/// All but the blocks and their pairs. Of a whole world, the share that owns its first free block takes the
/// losses.
template <int D>
void Assembly<D>::take_settings(std::span<const PackedBlock> blocks) {
  to_.model.settings = from_.model.settings;
  to_.model.materials = from_.model.materials;
  to_.model.water = from_.model.water;
  to_.clock = from_.clock;
  to_.strength_factor = from_.strength_factor;
  to_.edited = from_.edited;
  note_peaks(peaks_of(from_));
  const std::int64_t first = common_of_shares(from_).first_key;
  const auto is_first = [&](const PackedBlock& block) {
    return block.key == first && block.role == ShareRole::own;
  };
  if (from_.share.has_losses_of_its_own() || std::any_of(blocks.begin(), blocks.end(), is_first))
    to_.ledger = from_.ledger;
}

/// Adds the blocks in order, so that slot i is that of block i. A pair comes with the record of its first
/// block, or, where that is everywhere, with the other.
template <int D>
AssemblyFault Assembly<D>::take_blocks(std::span<const PackedBlock> blocks) {
  const auto precedes = [](const PackedBlock& block, std::int64_t key) { return block.key < key; };
  const auto slot_of = [&](std::int64_t key) {
    const auto found = std::lower_bound(blocks.begin(), blocks.end(), key, precedes);
    return found != blocks.end() && found->key == key ? std::int32_t(found - blocks.begin()) : -1;
  };
  NeighborList<D>& neighbors = to_.contacts.neighbors();
  const bool is_listed = from_.contacts.neighbors().builds() > 0;
  const bool with_gradients = to_.model.materials.any_elastic();
  BlockRecord<D> record(to_.memory());
  to_.share.reserve(blocks.size());
  to_.integrator.reserve(blocks.size());
  to_.integrator.resize(blocks.size());
  to_.model.blocks.begin_taking_over(from_.model.blocks, blocks.size());
  pairs_.reserve(from_.contacts.neighbors().pairs().size() * blocks.size() /
                 std::max<std::size_t>(1, from_.model.blocks.slot_count()));
  std::size_t last_known = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const PackedBlock& block = blocks[i];
    const std::int32_t known = living_slot_of(from_, block.key, last_known), self = std::int32_t(i);
    if (known >= 0) last_known = std::size_t(known);
    const AssemblyFault::Kind fault = read_record(block, known, record);
    if (fault != AssemblyFault::none) return {fault, i};
    if (known >= 0) {
      to_.model.blocks.add(record.state, from_.model.blocks, known);
      if (!block.bytes.empty()) to_.model.blocks.renew_outline(self);
    } else {
      to_.model.blocks.add(record.state, record.outline);
    }
    note_peaks(record.peaks);
    to_.share.add(block.key, block.role);
    to_.integrator.set_rates(i, {record.acceleration, record.momentum_rate});
    if (is_listed) neighbors.add_entry(record.entry, with_gradients);
    to_.contacts.add_new_mark(record.is_new);
    for (const PairRecord<D>& pair : record.pairs) {
      const std::int32_t partner = slot_of(pair.partner);
      if (partner < 0) {
        ++pairs_.missing[i];
      } else if (partner > self) {
        pairs_.add({self, partner, pair});
      } else if (blocks[std::size_t(partner)].role == ShareRole::everywhere) {
        pairs_.add_late({partner, self, pair});
      }
    }
  }
  to_.model.blocks.end_taking_over();
  pairs_.put_in_order();
  return {};
}

template <int D>
void Assembly<D>::take_pairs() {
  NeighborList<D>& neighbors = to_.contacts.neighbors();
  const bool with_shear =
      to_.model.materials.laws().any([](const ContactLaw& law) { return law.resists_shear(); });
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const auto& pair = pairs_[k];
    const PairRecord<D>& memory = pair.memory;
    neighbors.add_pair({pair.a, pair.b, memory.witness, memory.bonded, {}}, memory.shear, with_shear);
  }
  neighbors.end_taking_over(from_.contacts.neighbors());
  to_.share.find_rings(neighbors.pairs());
  to_.share.note_missing(pairs_.missing);
}

/// Motions and loads in time.
template <int D>
void Assembly<D>::take_actions() {
  const auto key_of = [&](std::int32_t slot) { return from_.share.key_of(std::size_t(slot)); };
  const auto slot_of = [&](std::int64_t key) { return living_slot_of(to_, key); };
  to_.model.actions.take_over(from_.model.actions, key_of, slot_of, to_.share.is_whole());
  if (!to_.model.actions.empty()) to_.model.actions.renew(to_.model.blocks);
}

/// Contacts and their forces.
template <int D>
void Assembly<D>::take_contacts() {
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (pairs_[k].memory.is_in_contact && to_.share.loads(pairs_[k])) to_.contacts.add_contact(k);
  }
  to_.contacts.end_taking_over(from_.contacts);
  stages_.fit_rooms();
  for (std::size_t k = 0; k < pairs_.size(); ++k) to_.forces.set_force(k, pairs_[k].memory.force);
  to_.forces.end_taking_over(from_.forces);
}

/// The loads on blocks that are everywhere are those that this share computes.
template <int D>
void Assembly<D>::load_everywhere() {
  const Blocks<D>& blocks = to_.model.blocks;
  if (!to_.forces.are_known()) return;
  const auto is_everywhere = [&](std::int32_t slot) { return !blocks.moves_freely(std::size_t(slot)); };
  for (std::size_t i = 0; i < blocks.slot_count(); ++i)
    if (is_everywhere(std::int32_t(i))) to_.forces.set_load(i, Vector<D>::Zero(), Angular<D>::Zero());
  const auto add = [&](std::int32_t slot, const Vector<D>& force, const Angular<D>& torque) {
    const std::size_t i = std::size_t(slot);
    to_.forces.set_load(i, blocks.force[i] + force, blocks.torque[i] + torque);
  };
  for (std::size_t c = 0; c < to_.contacts.count(); ++c) {
    const Candidate<D>& pair = to_.contacts.pair_of(c);
    const ContactForce<D>& load = to_.forces.of_contact(c);
    const Vector<D> to_b = blocks.position[std::size_t(pair.b)] - blocks.position[std::size_t(pair.a)];
    if (is_everywhere(pair.a)) add(pair.a, -load.force, load.torque_on_a());
    if (is_everywhere(pair.b)) add(pair.b, load.force, load.torque_on_b(to_b));
  }
  const double unit_weight =
      to_.model.water.empty() ? 0 : to_.model.water.unit_weight(to_.model.settings.gravity);
  for (std::size_t i = 0; i < blocks.slot_count() && unit_weight != 0; ++i) {
    if (!blocks.moves(i) || blocks.moves_freely(i) || !to_.share.wets(i)) continue;
    const WaterLoad<D> water = to_.model.water.load_on(blocks, i, unit_weight);
    to_.forces.add_load(i, water.force, water.virial);
  }
}

template <int D>
AssemblyFault Assembly<D>::assemble(std::span<const PackedBlock> blocks) {
  take_settings(blocks);
  const AssemblyFault fault = take_blocks(blocks);
  if (fault.kind != AssemblyFault::none) return fault;
  to_.share.end_adding(common_of_shares(from_));
  if (from_.model.materials.laws().knows_potential() || !to_.share.is_whole())
    to_.model.fixed_length = from_.model.potential_length();
  take_pairs();
  take_contacts();
  take_actions();
  load_everywhere();
  to_.integrator.look_what_moves();
  const auto was_sent = [](const PackedBlock& block) { return !block.bytes.empty(); };
  const bool is_trusted = std::none_of(blocks.begin(), blocks.end(), was_sent);
  const bool is_sound = is_trusted ? to_.model.actions.is_consistent(to_.model.blocks) : to_.is_consistent();
  return {is_sound ? AssemblyFault::none : AssemblyFault::inconsistent_state, 0};
}

}  // namespace

template <int D>
AssemblyFault assemble(World<D>& to, World<D>& from, std::span<const PackedBlock> blocks) {
  return Assembly<D>(to, from, blocks.size()).assemble(blocks);
}

#define HALFSPACE_FUNCTIONS(D)                                               \
  template bool BlockRecord<D>::is_complete() const;                         \
  template void write_record(State<D>&, std::size_t, bool, BlockRecord<D>&); \
  template AssemblyFault assemble(World<D>&, World<D>&, std::span<const PackedBlock>);

HALFSPACE_FUNCTIONS(2)
HALFSPACE_FUNCTIONS(3)
#undef HALFSPACE_FUNCTIONS

}  // namespace halfspace
