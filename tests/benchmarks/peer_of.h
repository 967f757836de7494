#pragma once

#include <algorithm>

#include "benchmarks/peers_3d.h"

namespace halfspace_benchmark {

/// A peer made of an engine: `Engine(set)` fills `pairs` in the order of the set, and `answer(pair)` is
/// inlined into the loop that is timed.
template <class Engine>
class PeerOf final : public Peer {
 public:
  explicit PeerOf(const PairSet3& set) : engine_(set) {}

  Answer answer(std::size_t pair) override { return engine_.answer(engine_.pairs[pair]); }
  void shuffle(Random& random) override { std::shuffle(engine_.pairs.begin(), engine_.pairs.end(), random); }
  int count_touching() override {
    int touching = 0;
    for (auto& pair : engine_.pairs) touching += engine_.answer(pair).touches;
    return touching;
  }

 private:
  Engine engine_;
};

}  // namespace halfspace_benchmark
