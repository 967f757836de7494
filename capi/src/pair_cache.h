#pragma once

#include "guard.h"
#include "halfspace/pair.h"
#include "narrow_phase/separation_proof.h"
#include "write_contact.h"

namespace halfspace::capi {

/// The remembered pair, not checked.
inline NamedPair pair_in(const hs_pair_cache& cache) {
  return {NamedPair::Kind(cache.pair_kind), cache.feature_a, cache.feature_b};
}

/// The witness of a pair in a cache, checked.
PairCache<2> read_cache(const hs_pair_cache& cache, const PosedPair<2>& posed);
PairCache<3> read_cache(const hs_pair_cache& cache, const PosedPair<3>& posed);

/// Writes the witness, and of a separated pair the proof in what has been found.
template <int D>
void write_cache(const PairCache<D>& witness, const PosedPair<D>& posed, const hs_contact& found,
                 hs_pair_cache& cache) {
  const NamedPair pair = named(witness.pair);
  cache.state = witness.state;
  cache.pair_kind = pair.kind;
  cache.feature_a = pair.a;
  cache.feature_b = pair.b;
  cache.shapes = 0;
  if (witness.state == PairCache<D>::separated) keep_proof(posed, found.normal, found.gap, cache);
}

/// The answer when the pair is still proven to be separated by more than the margin.
template <int D>
[[gnu::always_inline]] inline bool answer_by_proof(const PosedPair<D>& posed, const hs_pair_cache& cache,
                                                   hs_contact& out, double margin = 0) {
  if (cache.state != PairCache<D>::separated) return false;
  const double gap = proven_gap(posed, cache, margin);
  if (!(gap > 0)) return false;
  write_pair(ContactType::none, 0, separating(pair_in(cache)), Vector<D>(cache.normal), gap, out);
  return true;
}

}  // namespace halfspace::capi
