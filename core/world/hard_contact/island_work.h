#pragma once

#include <cstdint>

#include "world/motion/islands.h"

namespace halfspace {

/// Of the impulses of a contact, J.
struct ImpulseWork {
  double normal = 0;
  double friction = 0;
  double outer = 0;  // by prescribed blocks
  double size = 0;   // the sum of the magnitudes of all terms

  double sum() const { return normal + friction; }
  /// Between -1 and 1.
  double ratio() const { return size > 0 ? sum() / size : 0; }
  void add(const ImpulseWork& more) {
    normal += more.normal;
    friction += more.friction;
    outer += more.outer;
    size += more.size;
  }
};

/// The work of impulses in each island of free blocks that contacts connect. Blocks are joined before work is
/// added.
class IslandWork {
 public:
  explicit IslandWork(Memory* memory) : islands_(memory), work_(memory) {}

  void reserve(std::size_t blocks) {
    islands_.reserve(blocks);
    work_.reserve(blocks);
  }
  void begin(std::size_t blocks) {
    islands_.begin(blocks);
    work_.assign(blocks, {});
  }
  void join(std::int32_t a, std::int32_t b) { islands_.join(a, b); }
  ImpulseWork& of(std::int32_t block) { return work_[std::size_t(islands_.head_of(block))]; }

 private:
  Islands islands_;
  Array<ImpulseWork> work_;
};

}  // namespace halfspace
