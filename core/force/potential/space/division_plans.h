#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "force/potential/space/division_plan.h"
#include "geometry/vector.h"

namespace halfspace {

/// The reference of a pair of blocks to its plan, if any.
class DivisionCache {
 public:
  bool knows() const { return first_ >= 0; }
  /// The index of the first code of its plan.
  std::int32_t first() const { return first_; }
  void remember(std::int32_t first) { first_ = first; }
  void forget() { first_ = -1; }

 private:
  std::int32_t first_ = -1;
};

/// The plans of all pairs of blocks, one after the other. Unused plans occupy memory until tidy().
///
/// The capacity follows from the number of pairs and is reserved beforehand: steps allocate nothing, and a
/// restored world makes the same plans as the saved one.
class CachedDivisions {
 public:
  explicit CachedDivisions(Memory* memory) : codes_(memory) {}

  void reserve(std::size_t pairs) { codes_.reserve(room_for(pairs)); }
  /// Sets the limit of memory for this number of pairs, within the reserved capacity.
  void serve_pairs(std::size_t pairs) { room_ = std::min(room_for(pairs), codes_.capacity()); }

  std::span<const PlanCode> operator[](const DivisionCache& memory) const {
    const PlanCode* const head = codes_.data() + memory.first();
    return {head + head_size, std::size_t(head[0])};
  }

  /// False when there is no room left.
  bool add(std::span<const PlanCode> plan, DivisionCache& memory) {
    const std::size_t first = codes_.size();
    if (first + head_size + plan.size() > room_) {
      is_full_ = true;
      return false;
    }
    codes_.insert(codes_.end(), {PlanCode(plan.size()), 0, 0});
    codes_.insert(codes_.end(), plan.begin(), plan.end());
    memory.remember(std::int32_t(first));
    return true;
  }

  /// Removes plans that no pair refers to, when they are the majority or there is no room left.
  template <class Pairs>
  void tidy(Pairs& pairs) noexcept {
    if (codes_.size() <= enough_ && !is_full_) return;
    for (std::size_t k = 0; k < pairs.size(); ++k)
      if (pairs[k].plan.knows()) set_owner(std::size_t(pairs[k].plan.first()), k);
    std::size_t kept = 0, next = 0;
    for (std::size_t at = 0; at < codes_.size(); at = next) {
      next = at + head_size + std::size_t(codes_[at]);
      const std::size_t owner = owner_of(at);
      if (owner >= pairs.size() || !pairs[owner].plan.knows()) continue;
      if (std::size_t(pairs[owner].plan.first()) != at) continue;
      pairs[owner].plan.remember(std::int32_t(kept));
      std::copy(codes_.begin() + std::ptrdiff_t(at), codes_.begin() + std::ptrdiff_t(next),
                codes_.begin() + std::ptrdiff_t(kept));
      kept += next - at;
    }
    codes_.resize(kept);
    enough_ = 2 * kept + 4096;
    is_full_ = false;
  }

  std::size_t size() const { return codes_.size(); }

  /// False for data of a damaged snapshot. If true, each pair's plan is one of its own.
  template <class Pairs>
  bool are_of(const Pairs& pairs) const {
    Array<std::uint8_t> is_free_head(codes_.size(), 0, codes_.get_allocator());
    std::size_t at = 0;
    for (; at + head_size <= codes_.size() && codes_[at] > 0; at += head_size + std::size_t(codes_[at]))
      is_free_head[at] = 1;
    if (at != codes_.size()) return false;
    return std::all_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
      if (!pair.plan.knows()) return true;
      const std::size_t first = std::size_t(pair.plan.first());
      return first < is_free_head.size() && std::exchange(is_free_head[first], std::uint8_t(0));
    });
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(codes_, enough_);
  }

 private:
  /// The length of a plan, and its pair during tidy().
  static constexpr std::size_t head_size = 3;

  /// Usually enough even if all pairs are in contact: a plan has 200 to 500 codes.
  static std::size_t room_for(std::size_t pairs) {
    return std::min<std::size_t>(most_plan_codes + 512 * pairs, INT32_MAX / 2);
  }

  void set_owner(std::size_t at, std::size_t owner) {
    codes_[at + 1] = PlanCode(owner & 0xffff);
    codes_[at + 2] = PlanCode(owner >> 16);
  }
  std::size_t owner_of(std::size_t at) const {
    return std::size_t(std::uint16_t(codes_[at + 1])) | std::size_t(std::uint16_t(codes_[at + 2])) << 16;
  }

  Array<PlanCode> codes_;
  std::size_t room_ = 0;
  std::uint64_t enough_ = 0;
  bool is_full_ = false;
};

}  // namespace halfspace
