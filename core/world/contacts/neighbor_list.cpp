#include "world/contacts/neighbor_list.h"

#include <algorithm>

#include "geometry/numbers.h"
#include "geometry/tolerances.h"
#include "narrow_phase/features.h"
#include "narrow_phase/plane/separation.h"
#include "narrow_phase/space/separation.h"

namespace halfspace {
namespace {

/// Blocks or pairs that a worker processes at a time.
constexpr std::size_t things_per_chunk = 256;

/// Instead of the first block of a pair that cannot touch.
constexpr std::int32_t apart = -1;

/// Memory with a reserve, so that it changes seldom.
void adapt(std::size_t& room, std::size_t used) {
  if (used > room || 2 * used < room) room = used + used / 8;
}

}  // namespace

template <int D>
NeighborList<D>::NeighborList(Threads* threads, Memory* memory)
    : threads_(threads),
      pairs_(memory),
      shear_(memory),
      reference_position_(memory),
      reference_rotation_(memory),
      reference_gradient_(memory),
      skin_(memory),
      announced_(memory),
      safe_displacement_(memory),
      displacements_(memory),
      by_second_(memory),
      first_by_second_(memory),
      search_(memory),
      boxes_(memory),
      sizes_(memory),
      found_(memory),
      sorted_(memory),
      first_of_block_(memory),
      next_pairs_(memory),
      next_shear_(memory) {}

template <int D>
double NeighborList<D>::median_radius(const Blocks<D>& blocks) {
  sizes_.clear();
  for (std::size_t i = 0; i < blocks.slot_count(); ++i) {
    if (blocks.moves_freely(i) && !blocks.is_compound(i)) sizes_.push_back(blocks.radius[i]);
  }
  if (sizes_.empty()) return 0;
  const auto middle = sizes_.begin() + std::ptrdiff_t(sizes_.size() / 2);
  std::nth_element(sizes_.begin(), middle, sizes_.end());
  return *middle;
}

/// The skin is a fraction of the block's size, or of the median size if that is smaller: otherwise a large
/// plate would list many grains that it never meets. It covers at least as many announced motions as the rule
/// says, is no smaller than before where the rule says so, and is 0 for a fixed block.
template <int D>
void NeighborList<D>::choose_skins(const Blocks<D>& blocks, const SkinRule& rule) {
  const double typical = rule.typical_radius > 0 ? rule.typical_radius : median_radius(blocks);
  for (std::size_t i = 0; i < blocks.slot_count(); ++i) {
    const double announced =
        displacements_.empty() ? announced_[i] : announced_[i] - displacements_[i].norm();
    const double usual = rule.relative * 2 * std::min(blocks.radius[i], typical);
    const double min_skin = rule.may_shrink ? 0 : skin_[i];
    skin_[i] = blocks.moves(i) ? std::max({usual, rule.motions * announced, min_skin}) : 0;
  }
}

/// A pair is not fast when each block moves by at most half of the safe relative displacement.
template <int D>
void NeighborList<D>::choose_safe_displacements(const Blocks<D>& blocks) noexcept {
  std::fill(safe_displacement_.begin(), safe_displacement_.end(), HUGE_VAL);
  for (const Candidate<D>& pair : pairs_) {
    const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
    const double calm =
        0.5 * safe_thickness_fraction * std::min(blocks.strained_thickness(a), blocks.strained_thickness(b));
    safe_displacement_[a] = std::min(safe_displacement_[a], calm);
    safe_displacement_[b] = std::min(safe_displacement_[b], calm);
  }
  min_safe_displacement_ = HUGE_VAL;
  for (const double calm : safe_displacement_)
    min_safe_displacement_ = std::min(min_safe_displacement_, calm);
}

/// Blocks with overlapping boxes may have a gap larger than both skins; they cannot touch before the next
/// rebuild. This excludes one pair in five of packed triangles.
template <int D>
bool NeighborList<D>::may_touch(const Blocks<D>& blocks, const BlockPair& pair) const {
  const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
  const PlacedBlocks<D> at = blocks.placed(pair.a, pair.b);
  const double reach = skin_[a] + skin_[b] + way(a).norm() + way(b).norm();
  return find_separation(at.a, at.b, at.to_b).gap <= reach;
}

/// The boxes in which blocks may be until the next search. Blocks that do not move freely count only where a
/// free block may reach them, compounds by their parts.
template <int D>
void NeighborList<D>::measure_boxes(const Blocks<D>& blocks) {
  const std::size_t slots = blocks.slot_count();
  boxes_.resize(slots);
  const auto measure = [&](std::size_t i) {
    boxes_[i] = blocks.box(std::int32_t(i));
    const Vector<D> way = this->way(i);
    boxes_[i].lower = boxes_[i].lower.cwiseMin(boxes_[i].lower + way).array() - skin_[i];
    boxes_[i].upper = boxes_[i].upper.cwiseMax(boxes_[i].upper + way).array() + skin_[i];
  };
  for_each_chunk(threads_, slots, things_per_chunk, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      boxes_[i] = Box<D>();
      if (blocks.moves_freely(i) && !blocks.is_compound(i)) measure(i);
    }
  });
  Box<D> reached;
  for (const Box<D>& box : boxes_) {
    if (box.is_empty()) continue;
    reached.include(box.lower);
    reached.include(box.upper);
  }
  for_each_chunk(threads_, slots, things_per_chunk, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      if (blocks.moves_freely(i) || blocks.is_compound(i)) continue;
      const double reach = blocks.radius[i] + skin_[i] + way(i).norm();
      const Box<D> about{blocks.position[i].array() - reach, blocks.position[i].array() + reach};
      if (blocks.lives(i) && about.overlaps(reached)) measure(i);
    }
  });
}

/// Finds the pairs whose boxes overlap, then of these the ones that may touch, which costs more. Blocks that
/// both stand, or are joined, are no pair.
template <int D>
void NeighborList<D>::search(const Blocks<D>& blocks) {
  measure_boxes(blocks);
  found_.clear();
  refit(found_, room_of_found_);
  search_.search(
      std::span<const Box<D>>(boxes_), [&](std::size_t i) { return !boxes_[i].is_empty(); },
      [&](const BlockPair& pair) {
        const std::size_t a = std::size_t(pair.a), b = std::size_t(pair.b);
        if ((blocks.moves_freely(a) || blocks.moves_freely(b)) && !blocks.are_joined(a, b))
          found_.push_back(pair);
      });
  adapt(room_of_found_, found_.size());
  for_each_chunk(threads_, found_.size(), things_per_chunk, [&](const Chunk& chunk) {
    for (std::size_t k = chunk.begin; k < chunk.end; ++k)
      if (!may_touch(blocks, found_[k])) found_[k].a = apart;
  });
  std::erase_if(found_, [](const BlockPair& pair) { return pair.a == apart; });
  adapt(room_, found_.size());
}

/// Counting sort by a, then by b within each: linear, because a block has few neighbours.
template <int D>
void NeighborList<D>::sort_found(std::size_t slots) {
  first_of_block_.assign(slots + 1, 0);
  for (const BlockPair& pair : found_) ++first_of_block_[std::size_t(pair.a) + 1];
  for (std::size_t i = 0; i < slots; ++i) first_of_block_[i + 1] += first_of_block_[i];
  sorted_.clear();
  refit(sorted_, room_);
  sorted_.resize(found_.size());
  for (const BlockPair& pair : found_) sorted_[first_of_block_[std::size_t(pair.a)]++] = pair;
  auto first = sorted_.begin();
  for (std::size_t i = 0; i < slots; ++i) {
    const auto last = sorted_.begin() + first_of_block_[i];
    std::sort(first, last, [](const BlockPair& p, const BlockPair& q) { return p.b < q.b; });
    first = last;
  }
}

/// Merges both sorted lists. A bonded pair stays even if its boxes have separated.
template <int D>
void NeighborList<D>::carry_over(bool with_shear) noexcept {
  const auto precedes = [](const auto& p, const auto& q) { return p.a < q.a || (p.a == q.a && p.b < q.b); };
  next_pairs_.clear();
  next_shear_.clear();
  const auto keep = [&](const Candidate<D>& pair, const ShearSpring<D>& shear) {
    next_pairs_.push_back(pair);
    if (with_shear) next_shear_.push_back(shear);
  };
  const auto shear_of = [&](std::size_t old) { return shear_.empty() ? ShearSpring<D>{} : shear_[old]; };

  std::size_t old = 0;
  const auto keep_bonded = [&] {
    if (pairs_[old].bonded) keep(pairs_[old], shear_of(old));
    ++old;
  };
  for (const BlockPair& pair : sorted_) {
    while (old < pairs_.size() && precedes(pairs_[old], pair)) keep_bonded();
    const bool known = old < pairs_.size() && !precedes(pair, pairs_[old]);
    if (known) {
      keep(pairs_[old], shear_of(old));
      ++old;
    } else {
      keep(Candidate<D>{pair.a, pair.b, {}, 0, {}}, {});
    }
  }
  while (old < pairs_.size()) keep_bonded();
}

/// Reserves first, so that all arrays have the same length if memory runs out.
template <int D>
void NeighborList<D>::resize(std::size_t slots, bool with_gradients) {
  skin_.reserve(slots);
  announced_.reserve(slots);
  safe_displacement_.reserve(slots);
  reference_position_.reserve(slots);
  reference_rotation_.reserve(slots);
  if (with_gradients) reference_gradient_.resize(slots, Tensor<D>::Identity());
  skin_.resize(slots);
  announced_.resize(slots);
  safe_displacement_.resize(slots);
  if (!displacements_.empty()) displacements_.resize(slots, Vector<D>::Zero());
  reference_position_.resize(slots, Vector<D>::Zero());
  reference_rotation_.resize(slots);
}

template <int D>
void NeighborList<D>::search_again(const Blocks<D>& blocks, const SkinRule& skins, bool with_shear) {
  needs_rebuild_ = true;  // until renew(): new skins are for the new list
  resize(blocks.slot_count(), !blocks.deformations().empty());
  choose_skins(blocks, skins);
  search(blocks);
  sort_found(blocks.slot_count());
  const auto bonded =
      std::count_if(pairs_.begin(), pairs_.end(), [](const Candidate<D>& pair) { return pair.bonded; });
  const std::size_t most = std::max(room_, sorted_.size() + std::size_t(bonded));
  refit(next_pairs_, most);
  refit(next_shear_, with_shear ? most : 0);
}

template <int D>
void NeighborList<D>::renew(const Blocks<D>& blocks, bool with_shear) noexcept {
  carry_over(with_shear);
  pairs_.swap(next_pairs_);
  shear_.swap(next_shear_);
  for (std::size_t i = 0; i < blocks.slot_count(); ++i) {
    reference_position_[i] = blocks.position[i];
    reference_rotation_[i] = blocks.rotation[i];
  }
  for (const Deformation<D>& deformation : blocks.deformations().all())
    reference_gradient_[std::size_t(deformation.slot)] = deformation.gradient;
  choose_safe_displacements(blocks);
  displacements_.clear();
  is_indexed_ = false;
  needs_rebuild_ = false;
  is_outrun_ = false;
  ++builds_;
}

template <int D>
ListEntry<D> NeighborList<D>::entry_of(std::size_t slot) const {
  if (slot >= skin_.size()) return {};
  ListEntry<D> entry{reference_position_[slot], reference_rotation_[slot], Tensor<D>::Identity(), skin_[slot],
                     safe_displacement_[slot]};
  if (slot < reference_gradient_.size()) entry.gradient = reference_gradient_[slot];
  return entry;
}

template <int D>
void NeighborList<D>::add_entry(const ListEntry<D>& entry, bool with_gradients) {
  reference_position_.push_back(entry.position);
  reference_rotation_.push_back(entry.rotation);
  if (with_gradients) reference_gradient_.push_back(entry.gradient);
  skin_.push_back(entry.skin);
  safe_displacement_.push_back(entry.safe_displacement);
  announced_.push_back(0);
}

template <int D>
void NeighborList<D>::add_pair(const Candidate<D>& pair, const ShearSpring<D>& shear, bool with_shear) {
  pairs_.push_back(pair);
  if (with_shear) shear_.push_back(shear);
}

template <int D>
void NeighborList<D>::end_taking_over(const NeighborList& from) {
  min_safe_displacement_ = HUGE_VAL;
  for (const double calm : safe_displacement_)
    min_safe_displacement_ = std::min(min_safe_displacement_, calm);
  room_ = pairs_.size();
  is_indexed_ = false;
  needs_rebuild_ = from.needs_rebuild_;
  builds_ = from.builds_;
}

template <int D>
void NeighborList<D>::remember_pairs() {
  next_pairs_ = pairs_;
  next_shear_ = shear_;
}

template <int D>
void NeighborList<D>::recall_pairs() noexcept {
  is_indexed_ = false;
  pairs_.swap(next_pairs_);
  shear_.swap(next_shear_);
}

template <int D>
void NeighborList<D>::forget(std::int32_t slot) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (pairs_[k].a == slot || pairs_[k].b == slot) continue;
    pairs_[kept] = pairs_[k];
    if (!shear_.empty()) shear_[kept] = shear_[k];
    ++kept;
  }
  pairs_.resize(kept);
  is_indexed_ = false;
  if (!shear_.empty()) shear_.resize(kept);
  needs_rebuild_ = true;
}

template <int D>
std::optional<std::size_t> NeighborList<D>::pair_between(std::int32_t a, std::int32_t b) const {
  const std::pair wanted(std::min(a, b), std::max(a, b));
  const auto pair = std::lower_bound(
      pairs_.begin(), pairs_.end(), wanted,
      [](const Candidate<D>& one, const auto& blocks) { return std::pair(one.a, one.b) < blocks; });
  if (pair == pairs_.end() || std::pair(pair->a, pair->b) != wanted) return {};
  return std::size_t(pair - pairs_.begin());
}

/// A counting sort: pairs with the same second block stay in order of their first ones.
template <int D>
void NeighborList<D>::index_pairs() noexcept {
  if (is_indexed_) return;
  first_by_second_.assign(skin_.size() + 1, 0);
  for (const Candidate<D>& pair : pairs_) ++first_by_second_[std::size_t(pair.b)];
  std::uint32_t end = 0;
  for (std::uint32_t& first : first_by_second_) first = end += first;
  by_second_.resize(pairs_.size());
  for (std::size_t k = pairs_.size(); k-- > 0;)
    by_second_[--first_by_second_[std::size_t(pairs_[k].b)]] = std::uint32_t(k);
  is_indexed_ = true;
}

template <int D>
bool NeighborList<D>::is_consistent(const Blocks<D>& blocks) const {
  const std::size_t slots = blocks.slot_count();
  const std::size_t listed = list_length();
  if (listed > slots || announced_.size() != listed || safe_displacement_.size() != listed ||
      (!needs_rebuild_ && listed != slots))
    return false;
  if (reference_position_.size() != listed || reference_rotation_.size() != listed) return false;
  if (!shear_.empty() && shear_.size() != pairs_.size()) return false;
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
    const PairCache<D>& witness = pair.witness;
    constexpr auto last = D == 2 ? PairCache<D>::touching : PairCache<D>::overlapping;
    if (witness.state < PairCache<D>::unknown || witness.state > last) return false;
    const bool separated = witness.state == PairCache<D>::separated;
    return (separated || has_a_plane(witness.pair)) &&
           names_features(witness.pair, blocks.outline(pair.a), blocks.outline(pair.b));
  });
}

template class NeighborList<2>;
template class NeighborList<3>;

}  // namespace halfspace
