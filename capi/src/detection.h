#pragma once

#include "pair_cache.h"

namespace halfspace::capi {

// Detection of one pair in either dimension. The cache may be NULL.

/// Detects from the shapes. Refuses invalid poses and caches.
template <int D>
void judge(const PosedPair<D>& posed, const PairOptions& options, hs_pair_cache* cache, Memory* room,
           hs_contact& out);

/// Detects from the separation proof in the cache, or else from the shapes.
template <int D>
void detect(const PosedPair<D>& posed, const PairOptions& options, hs_pair_cache* cache, Memory* room,
            hs_contact& out) {
  if (!cache || !answer_by_proof(posed, *cache, out, options.margin)) judge(posed, options, cache, room, out);
}

}  // namespace halfspace::capi
