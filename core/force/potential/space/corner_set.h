#pragma once

#include <bit>
#include <cstdint>

#include "force/potential/space/division_plan.h"

namespace halfspace {

/// Some of a plan's corners.
class CornerSet {
 public:
  void add(int corner) { words_[corner / 64] |= std::uint64_t(1) << corner % 64; }
  bool has(int corner) const { return words_[corner / 64] >> corner % 64 & 1; }
  int count() const { return std::popcount(words_[0]) + std::popcount(words_[1]); }
  bool is_within(const CornerSet& other) const {
    return ((words_[0] & ~other.words_[0]) | (words_[1] & ~other.words_[1])) == 0;
  }
  CornerSet without(const CornerSet& other) const {
    CornerSet rest;
    for (int w = 0; w < 2; ++w) rest.words_[w] = words_[w] & ~other.words_[w];
    return rest;
  }
  bool operator==(const CornerSet&) const = default;

  friend CornerSet operator&(const CornerSet& a, const CornerSet& b) {
    CornerSet common;
    for (int w = 0; w < 2; ++w) common.words_[w] = a.words_[w] & b.words_[w];
    return common;
  }

  template <class Visit>
  void for_each(Visit visit) const {
    for (int w = 0; w < 2; ++w)
      for (std::uint64_t rest = words_[w]; rest != 0; rest &= rest - 1)
        visit(64 * w + std::countr_zero(rest));
  }

 private:
  static_assert(most_plan_corners == 128);
  std::uint64_t words_[2] = {};
};

}  // namespace halfspace
