#include "world/stages/pairs_by_law.h"

#include <algorithm>

namespace halfspace {

template <int D>
void PairsByLaw<D>::reserve(std::size_t pairs) {
  pairs_.reserve(pairs);
  begin_.reserve(groups * chunk_count(pairs, pairs_per_chunk) + 1);
}

template <int D>
std::size_t PairsByLaw<D>::group_of(const Model<D>& model, const Sleep<D>& sleep, const Share& share,
                                    const Candidate<D>& pair) const {
  const ContactLaw& law = model.law_of(pair);
  if (law.has_no_spring()) return none;
  if (sleep.leaves_out(pair)) return ContactList<D>::was_in_contact(pair) ? sleepers : none;
  return share.follows(pair) ? std::size_t(law.stiffness_kind) : none;
}

template <int D>
void PairsByLaw<D>::sort(const Model<D>& model, const Sleep<D>& sleep, const Share& share,
                         std::span<const Candidate<D>> pairs) {
  pairs_.clear();
  begin_.clear();
  for (std::size_t first = 0; first < pairs.size(); first += pairs_per_chunk) {
    const std::size_t count = std::min(pairs.size() - first, pairs_per_chunk);
    std::array<std::size_t, pairs_per_chunk> group;
    for (std::size_t i = 0; i < count; ++i) group[i] = group_of(model, sleep, share, pairs[first + i]);
    for (std::size_t g = 0; g < groups; ++g) {
      begin_.push_back(std::uint32_t(pairs_.size()));
      for (std::size_t i = 0; i < count; ++i) {
        if (group[i] == g) pairs_.push_back(std::uint32_t(first + i));
      }
    }
  }
  begin_.push_back(std::uint32_t(pairs_.size()));
}

template <int D>
bool PairsByLaw<D>::is_mixed(std::size_t chunk) const {
  std::size_t used = 0;
  for (std::size_t g = 0; g < groups; ++g) used += !group(g, chunk).empty();
  return used > 1;
}

template class PairsByLaw<2>;
template class PairsByLaw<3>;

}  // namespace halfspace
