#include "world/share/share.h"

#include <algorithm>

namespace halfspace {

std::int32_t Share::slot_of(std::int64_t key, std::size_t slots) const {
  if (keys_.empty()) return key >= 0 && std::uint64_t(key) < slots ? std::int32_t(key) : -1;
  const auto found = std::lower_bound(keys_.begin(), keys_.end(), key);
  return found != keys_.end() && *found == key ? std::int32_t(found - keys_.begin()) : -1;
}

void Share::end_adding(const Common& common) {
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
