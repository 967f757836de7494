#include "block/compounds.h"

#include <algorithm>
#include <utility>

namespace halfspace {

template <int D>
std::span<const Part<D>> Compounds<D>::parts_of(std::size_t compound) const {
  const auto is_here = [&](const Part<D>& part) { return part.compound == std::int32_t(compound); };
  const auto first = parts_.begin() + of_block_[compound];
  return {first, std::find_if_not(first, parts_.end(), is_here)};
}

template <int D>
void Compounds<D>::make_room(std::size_t parts, std::size_t slots) {
  const auto make_room = [](auto& array, std::size_t count) {
    if (array.capacity() < count) array.reserve(std::max(count, 2 * array.capacity()));
  };
  make_room(parts_, parts_.size() + parts);
  make_room(of_block_, slots);
  make_room(compound_of_, slots);
}

template <int D>
void Compounds<D>::set_compound(std::int32_t slot, std::int32_t compound) {
  const std::size_t s = std::size_t(slot);
  if (compound_of_.size() <= s) {
    compound_of_.resize(s + 1, -1);
    of_block_.resize(s + 1, -1);
  }
  compound_of_[s] = compound;
}

template <int D>
void Compounds<D>::add(std::int32_t compound) {
  set_compound(compound, compound);
  of_block_[std::size_t(compound)] = std::int32_t(parts_.size());
}

template <int D>
void Compounds<D>::add(const Part<D>& part) {
  set_compound(part.block, part.compound);
  of_block_[std::size_t(part.block)] = std::int32_t(parts_.size());
  parts_.push_back(part);
}

template <int D>
void Compounds<D>::remove(std::int32_t compound) {
  std::erase_if(parts_, [&](const Part<D>& part) { return part.compound == compound; });
  std::replace(compound_of_.begin(), compound_of_.end(), compound, -1);
  while (!compound_of_.empty() && compound_of_.back() < 0) compound_of_.pop_back();
  index_parts();
}

template <int D>
void Compounds<D>::index_parts() {
  of_block_.assign(compound_of_.size(), -1);
  for (std::size_t i = parts_.size(); i-- > 0;)
    of_block_[std::size_t(parts_[i].block)] = of_block_[std::size_t(parts_[i].compound)] = std::int32_t(i);
}

/// Each compound has a part, and its parts follow each other.
template <int D>
bool Compounds<D>::is_consistent(std::size_t slots) const {
  const std::size_t count = compound_of_.size();
  if (count > slots || of_block_.size() != count) return false;
  std::size_t compounds = 0, parts = 0, runs = 0;
  for (std::size_t slot = 0; slot < count; ++slot) {
    const std::int32_t compound = compound_of_[slot], here = of_block_[slot];
    if (compound == -1) continue;
    if (compound < 0 || std::size_t(compound) >= count || !is_compound(std::size_t(compound))) return false;
    if (here < 0 || std::size_t(here) >= parts_.size()) return false;
    const Part<D>& part = parts_[std::size_t(here)];
    if (part.compound != compound || (is_part(slot) && part.block != std::int32_t(slot))) return false;
    is_part(slot) ? ++parts : ++compounds;
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const bool is_first = i == 0 || parts_[i].compound != parts_[i - 1].compound;
    const std::size_t compound = std::size_t(parts_[i].compound);
    if (compound >= count || (is_first && of_block_[compound] != std::int32_t(i))) return false;
    if (!parts_[i].pose.position.allFinite()) return false;
    runs += is_first;
  }
  return parts == parts_.size() && runs == compounds;
}

template class Compounds<2>;
template class Compounds<3>;

}  // namespace halfspace
