#pragma once

// libhalfspace as a host calls it about one pair: hs_pair_detect on shapes and poses.

#include "benchmarks/peers_3d.h"

namespace halfspace_benchmark {

/// Without a cache.
std::unique_ptr<Peer> make_called_cold(const PairSet3& set);

/// Each pair with a cache of its own, which the question before has left behind.
std::unique_ptr<Peer> make_called_warm(const PairSet3& set);

}  // namespace halfspace_benchmark
