#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <type_traits>

#include "block/blocks.h"
#include "broad_phase/grid.h"
#include "force/spring/shear_spring.h"
#include "narrow_phase/contact.h"
#include "threads/threads.h"

namespace halfspace {

struct NoPadding {};

/// A pair of blocks that may touch soon, a < b, and its cached data. Without implicit padding, so that
/// snapshots contain no undefined bytes.
template <int D>
struct Candidate {
  std::int32_t a;
  std::int32_t b;
  PairCache<D> witness;
  std::int32_t bonded = 0;
  [[no_unique_address]] std::conditional_t<D == 2, NoPadding, std::int32_t> reserved{};
};
static_assert(sizeof(Candidate<2>) == sizeof(PairCache<2>) + 3 * sizeof(std::int32_t) &&
              sizeof(Candidate<3>) == sizeof(PairCache<3>) + 4 * sizeof(std::int32_t));

/// How far blocks may move before the list is renewed.
struct SkinRule {
  double relative;     // skin over block size
  double motions = 1;  // announced motions that a skin covers at least
  bool may_shrink = true;
  double typical_radius = 0;  // larger blocks have the skin of one of this radius; 0: the median
};

/// The data of a block in the list in use.
template <int D>
struct ListEntry {
  Vector<D> position = Vector<D>::Zero();  // at the last search, as the rotation and the gradient
  Rotation<D> rotation;
  Tensor<D> gradient = Tensor<D>::Identity();
  double skin = 0;
  double safe_displacement = HUGE_VAL;

  template <class Archive>
  void visit(Archive& archive) {
    archive(position, rotation, gradient, skin, safe_displacement);
  }
};

/// The neighbour list: all pairs that can touch before some block has moved by more than its skin. Sorted by
/// (a, b).
template <int D>
class NeighborList {
 public:
  /// The threads, if any, search.
  NeighborList(Threads* threads, Memory* memory);

  /// True when a block may touch another that is not in its list.
  bool needs_rebuild() const { return needs_rebuild_ || is_outrun_; }
  void invalidate() { needs_rebuild_ = true; }

  /// After all blocks have announced their motion: is some skin too small for it? The last motion announced
  /// counts.
  void end_announcements(bool is_outrun) {
    displacements_.clear();
    is_outrun_ = is_outrun;
  }
  /// Announces the maximum displacement of a block's points. Call for each block before it moves. Returns
  /// true when its skin is too small for that.
  bool announce(const Blocks<D>& blocks, std::size_t slot, double motion) {
    announced_[slot] = motion;
    return !(moved(blocks, slot) + motion <= skin_[slot]);
  }
  /// The announced motion will not be made.
  void forget_announcements() { is_outrun_ = false; }
  /// Announces a large displacement of the centroid. The search then extends along it instead of in all
  /// directions.
  void announce_displacement(std::size_t slot, const Vector<D>& way) {
    displacements_.resize(announced_.size(), Vector<D>::Zero());
    displacements_[slot] = way;
  }
  double announced_motion(std::size_t slot) const { return announced_[slot]; }
  /// Maximum displacement per step of a block that is not fast, for any of its neighbours.
  double safe_displacement(std::size_t slot) const { return safe_displacement_[slot]; }
  /// A lower bound of safe_displacement() over all blocks.
  double min_safe_displacement() const { return min_safe_displacement_; }

  /// Call after a block has been placed elsewhere.
  void note_placement(const Blocks<D>& blocks, std::size_t slot) {
    const bool is_listed = slot < skin_.size();
    if (!is_listed || !(moved(blocks, slot) <= skin_[slot])) needs_rebuild_ = true;
  }

  /// Searches for pairs, and reserves all memory of the new list. The pairs in use and their cached data do
  /// not change. `with_shear`: some law needs a shear spring.
  void search_again(const Blocks<D>& blocks, const SkinRule& skins, bool with_shear);
  /// Replaces the list by the new one. Pairs in both keep their cached data.
  void renew(const Blocks<D>& blocks, bool with_shear) noexcept;

  /// Keeps a copy of the pairs and their springs, until the list is renewed.
  void remember_pairs();
  void recall_pairs() noexcept;
  /// State that a search writes before it may run out of memory.
  auto skins() { return std::tie(skin_, needs_rebuild_, is_outrun_); }

  /// The median radius of the free blocks.
  double median_radius(const Blocks<D>& blocks);
  ListEntry<D> entry_of(std::size_t slot) const;
  double skin_of(std::size_t slot) const { return slot < skin_.size() ? skin_[slot] : 0; }

  // Taking over a list in use: first the entries of all slots in order, then the pairs in order.
  void add_entry(const ListEntry<D>& entry, bool with_gradients);
  void add_pair(const Candidate<D>& pair, const ShearSpring<D>& shear, bool with_shear);
  void end_taking_over(const NeighborList& from);

  /// Removes the pairs of a removed block.
  void forget(std::int32_t slot);

  /// Calls `visit(k)` for each pair of a block, in ascending order of the other block. Precondition: pairs
  /// have not changed since index_pairs().
  template <class Visit>
  void for_each_pair_of(std::int32_t slot, Visit visit) const {
    for (std::uint32_t i = first_by_second_[std::size_t(slot)]; i < first_by_second_[std::size_t(slot) + 1];
         ++i)
      visit(by_second_[i]);
    const auto is_before = [](const Candidate<D>& pair, std::int32_t block) { return pair.a < block; };
    auto pair = std::lower_bound(pairs_.begin(), pairs_.end(), slot, is_before);
    for (; pair != pairs_.end() && pair->a == slot; ++pair) visit(std::size_t(pair - pairs_.begin()));
  }
  /// The pair of two blocks, in either order, if it is in the list.
  std::optional<std::size_t> pair_between(std::int32_t a, std::int32_t b) const;
  /// Builds the index of pairs by second block, unless it is current. Allocates nothing after
  /// reserve_index().
  void index_pairs() noexcept;
  void reserve_index() {
    by_second_.reserve(room());
    first_by_second_.reserve(skin_.size() + 1);
    is_indexed_ = false;
  }

  Array<Candidate<D>>& pairs() { return pairs_; }
  const Array<Candidate<D>>& pairs() const { return pairs_; }
  /// One per pair; empty when no law resists shear.
  std::span<ShearSpring<D>> shear() { return shear_; }
  /// Capacity of arrays per contact: all pairs, and a reserve, so that the changing pairs of a settled heap
  /// cause no allocation.
  std::size_t room() const { return std::max(pairs_.capacity(), next_pairs_.capacity()); }
  std::int64_t builds() const { return builds_; }
  /// The number of slots at the last search.
  std::size_t list_length() const { return skin_.size(); }
  bool has_springs() const { return shear_.size() == pairs_.size(); }

  /// Validates the state read from a snapshot.
  bool is_consistent(const Blocks<D>& blocks) const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(pairs_, shear_, reference_position_, reference_rotation_, reference_gradient_, skin_, announced_,
            safe_displacement_, needs_rebuild_, builds_);
  }

 private:
  /// Upper bound of the displacement of a block's points since the last search.
  double moved(const Blocks<D>& blocks, std::size_t slot) const {
    const double way = (blocks.position[slot] - reference_position_[slot]).norm();
    if (!blocks.is_deformable(slot))
      return way + blocks.radius[slot] * blocks.rotation[slot].farthest_from(reference_rotation_[slot]);
    if (slot >= reference_gradient_.size()) return HUGE_VAL;
    return way + blocks.radius[slot] * (blocks.deformation(slot).gradient - reference_gradient_[slot]).norm();
  }

  void choose_skins(const Blocks<D>& blocks, const SkinRule& rule);
  void choose_safe_displacements(const Blocks<D>& blocks) noexcept;
  Vector<D> way(std::size_t slot) const {
    return displacements_.empty() ? Vector<D>::Zero() : displacements_[slot];
  }
  bool may_touch(const Blocks<D>& blocks, const BlockPair& pair) const;
  void resize(std::size_t slots, bool with_gradients);
  void measure_boxes(const Blocks<D>& blocks);
  void search(const Blocks<D>& blocks);
  void sort_found(std::size_t slots);
  void carry_over(bool with_shear) noexcept;

  Threads* threads_;
  Array<Candidate<D>> pairs_;
  Array<ShearSpring<D>> shear_;
  Array<Vector<D>> reference_position_;
  Array<Rotation<D>> reference_rotation_;
  Array<Tensor<D>> reference_gradient_;  // of deformable blocks, if there are any
  Array<double> skin_;
  Array<double> announced_;           // motion announced for the coming step
  Array<double> safe_displacement_;   // up to which a block is not fast, for any neighbour
  Array<Vector<D>> displacements_;    // of centroids, until the next search; empty: none is large
  double min_safe_displacement_ = 0;  // not saved: 0 until the next search
  std::int32_t needs_rebuild_ = 1;
  bool is_outrun_ = false;  // by the announced motion
  std::int64_t builds_ = 0;

  // Index of pairs by second block, and its first entry per block; built on demand.
  Array<std::uint32_t> by_second_;
  Array<std::uint32_t> first_by_second_;
  bool is_indexed_ = false;

  // Working memory of the search, kept so that it allocates nothing in a steady run.
  Grid<D> search_;
  Array<Box<D>> boxes_;
  Array<double> sizes_;
  std::size_t room_of_found_ = 0;
  std::size_t room_ = 0;
  Array<BlockPair> found_;
  Array<BlockPair> sorted_;
  Array<std::uint32_t> first_of_block_;
  Array<Candidate<D>> next_pairs_;
  Array<ShearSpring<D>> next_shear_;
};

extern template class NeighborList<2>;
extern template class NeighborList<3>;

}  // namespace halfspace
