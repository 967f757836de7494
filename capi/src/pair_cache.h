#pragma once

#include "guard.h"
#include "halfspace/pair.h"
#include "narrow_phase/separation_proof.h"
#include "write_contact.h"

namespace halfspace::capi {

/// The cached pair, not validated.
inline NamedPair pair_in(const hs_pair_cache& cache) {
  return {NamedPair::Kind(cache.pair_kind), cache.feature_a, cache.feature_b};
}

/// The state of a pair from its cache, validated.
PairCache<2> read_cache(const hs_pair_cache& cache, const PosedPair<2>& posed);
PairCache<3> read_cache(const hs_pair_cache& cache, const PosedPair<3>& posed);

/// Writes the state of a pair and, if it is separated, the separation proof from the contact `found`.
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

/// If the separation proof still implies a gap above the margin, writes the contact and returns true.
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
