#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "world/contacts/contact_list.h"
#include "world/model/model.h"
#include "world/model/share.h"
#include "world/motion/sleep.h"

namespace halfspace {

/// The pairs of the neighbour list, chunk by chunk, under the kinds of their laws, so that the pass over
/// pairs asks none of them for it. Pairs without springs, pairs that sleep apart, and those that only other
/// shares compute are under none.
template <int D>
class PairsByLaw {
 public:
  explicit PairsByLaw(Memory* memory) : pairs_(memory), begin_(memory) {}

  /// Reserves memory for this number of pairs.
  void reserve(std::size_t pairs);
  /// Sorts the pairs of a list by the kinds of their laws. Allocates nothing after reserve().
  void sort(const Model<D>& model, const Sleep<D>& sleep, const Share& share,
            std::span<const Candidate<D>> pairs);
  /// True when no pair has springs here.
  bool empty() const { return pairs_.empty(); }

  /// The awake pairs of a chunk under laws of a kind, in ascending order.
  std::span<const std::uint32_t> under(StiffnessKind kind, std::size_t chunk) const {
    return group(std::size_t(kind), chunk);
  }
  /// The pairs of a chunk that sleep in contact.
  std::span<const std::uint32_t> asleep(std::size_t chunk) const { return group(sleepers, chunk); }
  /// Are the pairs of a chunk in several of these groups?
  bool is_mixed(std::size_t chunk) const;

 private:
  static constexpr std::size_t sleepers = std::size_t(StiffnessKind::last) + 1, groups = sleepers + 1,
                               none = groups;

  std::size_t group_of(const Model<D>& model, const Sleep<D>& sleep, const Share& share,
                       const Candidate<D>& pair) const;
  std::span<const std::uint32_t> group(std::size_t group, std::size_t chunk) const {
    const std::uint32_t* const begin = begin_.data() + chunk * groups + group;
    return {pairs_.data() + begin[0], pairs_.data() + begin[1]};
  }

  Array<std::uint32_t> pairs_;  // group by group, chunk by chunk
  Array<std::uint32_t> begin_;  // of each group of each chunk, and the end
};

extern template class PairsByLaw<2>;
extern template class PairsByLaw<3>;

}  // namespace halfspace
