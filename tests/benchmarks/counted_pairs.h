#pragma once

// Pairs of blocks in contact, for count_instructions.

#include <vector>

#include "capi/handles.h"

namespace halfspace_benchmark {

/// Pairs that overlap a little, with their caches.
class CountedPairs {
 public:
  CountedPairs(hs_context* context, int dimension, int count);

  /// Moves all by a thousandth of their size, to and fro, and detects their contacts.
  void detect();

 private:
  struct Pair {
    halfspace_test::Shape a, b;
    hs_pose pose_a, pose_b;
    hs_pair_cache cache;
  };

  hs_contact contact_of(Pair& pair) const;

  hs_context* context_;
  double shift_ = 1e-3;
  std::vector<Pair> pairs_;
};

}  // namespace halfspace_benchmark
