#pragma once

#include "pair.h"
#include "posed_pair.h"
#include "separation_proof.h"

namespace halfspace::capi {

// Detection of one pair in either dimension. The cache may be NULL.

/// By looking at the shapes. Refuses poses and a cache that are wrong.
void judge(const PosedPair<2>& posed, const PairOptions& options, hs_pair_cache* cache, hs_contact& out);
void judge(const PosedPair<3>& posed, const PairOptions& options, hs_pair_cache* cache, hs_contact& out);

/// Refuses what judge() would, and writes nothing.
void require_readable(const PosedPair<2>& posed, const hs_pair_cache* cache);
void require_readable(const PosedPair<3>& posed, const hs_pair_cache* cache);

/// By the proof in the cache, or else by looking at the shapes.
template <int D>
void detect(const PosedPair<D>& posed, const PairOptions& options, hs_pair_cache* cache, hs_contact& out) {
  if (!cache || !answer_by_proof(posed, *cache, out, options.margin)) judge(posed, options, cache, out);
}

}  // namespace halfspace::capi
