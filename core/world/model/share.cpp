#include "world/model/share.h"

#include <algorithm>

namespace halfspace {

/// A search in steps that double, as hosts ask for keys in ascending order.
std::int32_t Share::slot_of(std::int64_t key, std::size_t slots, std::size_t near) const {
  if (keys_.empty()) return key >= 0 && std::uint64_t(key) < slots ? std::int32_t(key) : -1;
  std::size_t begin = near < keys_.size() && keys_[near] <= key ? near : 0, step = 1;
  while (begin + step < keys_.size() && keys_[begin + step] < key) {
    begin += step;
    step *= 2;
  }
  const auto first = keys_.begin() + std::ptrdiff_t(begin);
  const auto found =
      std::lower_bound(first, first + std::ptrdiff_t(std::min(step + 1, keys_.size() - begin)), key);
  return found != keys_.end() && *found == key ? std::int32_t(found - keys_.begin()) : -1;
}

void Share::end_adding(const Common& common) {
  has_losses_of_its_own_ = 1;
  const bool has_copies = std::find(roles_.begin(), roles_.end(), ShareRole::neighbor) != roles_.end();
  if (!has_copies && std::int64_t(roles_.size()) == common.blocks) return roles_.clear();
  common_ = common;
  slot_of_first_ = slot_of(common.first_key, roles_.size());
}

void Share::note_missing(std::span<const std::int32_t> missing) {
  for (std::size_t i = 0; i < missing.size(); ++i) {
    if (is_whole() || rings_[i] < 2) lost_pairs_ += missing[i];
  }
}

}  // namespace halfspace
