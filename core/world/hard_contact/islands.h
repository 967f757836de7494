#pragma once

#include <cstdint>
#include <numeric>

#include "geometry/vector.h"

namespace halfspace {

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
  std::int32_t head_of(std::int32_t block) {
    while (above_[std::size_t(block)] != block) {
      std::int32_t& above = above_[std::size_t(block)];
      above = above_[std::size_t(above)];
      block = above;
    }
    return block;
  }

 private:
  Array<std::int32_t> above_;  // of each block: itself, or another one of its island
};

}  // namespace halfspace
