#pragma once

#include <cstdint>
#include <numeric>
#include <span>

#include "geometry/vector.h"

namespace halfspace {

/// The head of the island of a block, by union and find. `above`: of each block itself, or another one of its
/// island.
inline std::int32_t head_of_island(std::span<std::int32_t> above, std::int32_t block) {
  while (above[std::size_t(block)] != block) {
    std::int32_t& next = above[std::size_t(block)];
    next = above[std::size_t(next)];
    block = next;
  }
  return block;
}

/// The islands of blocks that contacts connect, by union and find: each is known by the slot of one of its
/// blocks, its head.
class Islands {
 public:
  explicit Islands(Memory* memory) : above_(memory) {}

  void reserve(std::size_t blocks) { above_.reserve(blocks); }
  /// Each block is an island.
  void begin(std::size_t blocks) {
    above_.resize(blocks);
    std::iota(above_.begin(), above_.end(), 0);
  }
  void join(std::int32_t a, std::int32_t b) { above_[std::size_t(head_of(a))] = head_of(b); }
  std::int32_t head_of(std::int32_t block) { return head_of_island(above_, block); }

 private:
  Array<std::int32_t> above_;  // of each block: itself, or another one of its island
};

}  // namespace halfspace
