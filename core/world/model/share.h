#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "geometry/numbers.h"
#include "geometry/vector.h"

namespace halfspace {

/// The role of a block in a share of a world. The values are those of the C API.
enum class ShareRole : std::int32_t {
  own = 0,        // this share loads it and counts its energy
  neighbor = 1,   // a copy: it moves alike, and its loads come from the share that owns it
  everywhere = 2  // fixed or prescribed, in all shares
};

/// The stages of a step in pieces.
enum class ShareStage { ready, begun, planned, moved };

// A world may be a share of a larger one: some of its blocks are its own, and others are copies, as far as
// two pairs of the neighbour list away from an own one:
//
//   ring 0   own blocks: all their pairs are here, so their loads are complete
//   ring 1   copies that have a pair with an own block
//   ring 2   copies that have a pair with ring 1; between copies, only bonds need forces
//   idle     other copies: nothing depends on them until the next assembly
//
// The entry face of a pair that meets depends on the other contacts of both blocks (Entrances), so the memory
// of the pairs of ring 1 has to be exact as well. It is, because their contacts are found and loaded from the
// same poses and velocities as by their owner, except where such a pair meets: its entry face depends on
// ring 2. The owner then asks for an assembly before the next motion, which brings the memory of its pairs.

/// The roles of a world's blocks, if it is a share of a larger world.
class Share {
 public:
  explicit Share(Memory* memory)
      : keys_(memory), roles_(memory), rings_(memory), is_border_(memory), is_idle_(memory) {}

  /// All blocks are own ones. A share may be without any.
  bool is_whole() const { return common_.blocks == 0; }
  bool is_own(std::size_t slot) const { return is_whole() || roles_[slot] == ShareRole::own; }
  /// A copy that need not move.
  bool is_idle(std::size_t slot) const { return !is_idle_.empty() && is_idle_[slot]; }
  /// Since the last new list some copies may have rested. Their places are of no use to another list.
  bool has_stale_copies() const { return !is_idle_.empty(); }
  bool is_copy(std::size_t slot) const { return !is_whole() && roles_[slot] == ShareRole::neighbor; }
  ShareRole role_of(std::size_t slot) const { return is_whole() ? ShareRole::own : roles_[slot]; }

  /// Does a pair load an own block?
  template <class Pair>
  bool loads(const Pair& pair) const {
    return is_own(std::size_t(pair.a)) || is_own(std::size_t(pair.b));
  }
  /// Are the energies of a pair counted here? Of two shares that load a pair, the owner of its first block
  /// counts them.
  template <class Pair>
  bool counts(const Pair& pair) const {
    return is_own(std::size_t(pair.a)) || (!is_copy(std::size_t(pair.a)) && is_own(std::size_t(pair.b)));
  }
  /// Does water act on a block here? On one that is everywhere it does in the share that owns the first free
  /// block of all.
  bool wets(std::size_t slot) const {
    return is_own(slot) || (!is_copy(slot) && slot_of_first_ >= 0 && is_own(std::size_t(slot_of_first_)));
  }
  /// Is the memory of a pair exact here? Others are not computed.
  template <class Pair>
  bool follows(const Pair& pair) const {
    return is_whole() || rings_[std::size_t(pair.a)] < 2 || rings_[std::size_t(pair.b)] < 2;
  }

  /// The name of a block in all shares; without keys its place among the blocks.
  std::int64_t key_of(std::size_t slot) const { return keys_.empty() ? std::int64_t(slot) : keys_[slot]; }
  /// The slot of a key among so many; -1: none. `near`: a slot that may be a little before it.
  std::int32_t slot_of(std::int64_t key, std::size_t slots, std::size_t near = 0) const;
  /// In ascending order. Empty: places.
  void set_keys(std::span<const std::int64_t> keys) { keys_.assign(keys.begin(), keys.end()); }
  void forget_keys() { keys_.clear(); }

  void reserve(std::size_t slots) {
    keys_.reserve(slots);
    roles_.reserve(slots);
  }
  void add(std::int64_t key, ShareRole role) {
    keys_.push_back(key);
    roles_.push_back(role);
  }
  /// Properties that all shares of a world have in common.
  struct Common {
    std::int64_t blocks = 0;     // of all shares, copies not counted; in a whole world not set
    std::int64_t first_key = 0;  // of the free blocks
    double typical_radius = 0;   // their median
  };
  const Common& common() const { return common_; }
  /// Call when all blocks have been added. With all blocks of the world, and no copies, a share is whole.
  void end_adding(const Common& common);
  /// Are the losses those of this share alone? Those of a whole world go to one of its shares. A share that
  /// owns all blocks is whole, but others may have losses.
  bool has_losses_of_its_own() const { return !is_whole() || has_losses_of_its_own_ != 0; }
  void take_all_losses() { has_losses_of_its_own_ = 0; }

  /// Finds the rings, and which own blocks are in ring 1 of another share. `pairs`: of the list in use.
  template <class Pairs>
  void find_rings(const Pairs& pairs) {
    if (is_whole()) return;
    rings_.assign(roles_.size(), 2);
    is_border_.assign(roles_.size(), 0);
    for (std::size_t i = 0; i < roles_.size(); ++i) {
      if (is_own(i)) rings_[i] = 0;
    }
    for (const auto& pair : pairs) {
      const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
      meet(a, b);
      meet(b, a);
    }
  }
  /// Finds the idle copies, from the rings. Only for a list that has just been made: until then, each block
  /// has to plan its motion, from which skins follow.
  template <class Pairs>
  void find_idle(const Pairs& pairs) {
    if (is_whole()) return;
    is_idle_.resize(roles_.size());
    for (std::size_t i = 0; i < roles_.size(); ++i) is_idle_[i] = is_copy(i) && rings_[i] == 2;
    for (const auto& pair : pairs) {
      const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
      if (rings_[a] == 1) is_idle_[b] = 0;
      if (rings_[b] == 1) is_idle_[a] = 0;
    }
  }
  /// An entry face has followed from the contacts of an own pair's blocks. Other shares that compute the pair
  /// cannot know it.
  template <class Pair>
  void note_entrance(const Pair& pair) {
    if (!is_whole() && (is_border_[std::size_t(pair.a)] || is_border_[std::size_t(pair.b)]))
      needs_assembly_ = 1;
  }
  /// `missing`: per block, how many of its pairs are with blocks that are not here. Call after find_rings().
  void note_missing(std::span<const std::int32_t> missing);
  bool needs_assembly() const { return needs_assembly_ != 0; }

  ShareStage stage() const { return stage_; }
  void enter(ShareStage stage) { stage_ = stage; }

  /// Snapshots have neither the stage, as they are taken between steps, nor the rings.
  template <class Archive>
  void visit(Archive& archive) {
    archive(keys_, roles_, is_idle_, common_, slot_of_first_, lost_pairs_, needs_assembly_,
            has_losses_of_its_own_);
  }
  /// `is_fixed(i)`: the block of a slot has one motion everywhere.
  template <class IsFixed>
  bool is_consistent(std::size_t slots, IsFixed is_fixed) const {
    const auto is_per_slot = [&](const auto& array) { return array.empty() || array.size() == slots; };
    if (!is_per_slot(keys_) || !is_per_slot(is_idle_) || keys_.size() < roles_.size() || common_.blocks < 0 ||
        roles_.size() != (is_whole() ? 0 : slots))
      return false;
    for (std::size_t i = 0; i < roles_.size(); ++i) {
      const bool is_everywhere = roles_[i] == ShareRole::everywhere;
      if (is_everywhere != is_fixed(i) || !(is_everywhere || is_own(i) || is_copy(i))) return false;
    }
    return std::is_sorted(keys_.begin(), keys_.end()) && slot_of_first_ < std::int64_t(slots) &&
           is_nonnegative(common_.typical_radius);
  }

  /// Pairs of rings 0 and 1 whose other block is not here: the copies do not reach far enough.
  std::int64_t lost_pairs() const { return lost_pairs_; }

 private:
  /// An own block has a pair with another block.
  void meet(std::size_t own, std::size_t other) {
    if (!is_own(own) || !is_copy(other)) return;
    rings_[other] = 1;
    is_border_[own] = 1;
  }

  Array<std::int64_t> keys_;  // per slot; empty: places
  Array<ShareRole> roles_;    // per slot; none in a whole world
  Array<std::uint8_t> rings_;
  Array<std::uint8_t> is_border_;
  Array<std::uint8_t> is_idle_;  // empty: none is
  Common common_;
  std::int32_t slot_of_first_ = -1;  // of the free blocks of all; -1: it is not here
  std::int64_t lost_pairs_ = 0;
  std::int32_t needs_assembly_ = 0;
  std::int32_t has_losses_of_its_own_ = 0;
  ShareStage stage_ = ShareStage::ready;
};

}  // namespace halfspace
