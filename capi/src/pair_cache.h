#pragma once

#include "contact.h"
#include "guard.h"
#include "halfspace/pair.h"

namespace halfspace::capi {

/// The remembered pair, not checked.
inline NamedPair pair_in(const hs_pair_cache& cache) {
  return {NamedPair::Kind(cache.pair_kind), cache.feature_a, cache.feature_b};
}

inline void require_state(const hs_pair_cache& cache) {
  if (cache.state < PairMemory<2>::unknown || cache.state > PairMemory<2>::touching) {
    refuse(HS_ERROR_ARGUMENT, "cache->state is %d; it must be 0, 1 or 2", cache.state);
  }
}

/// `last` is the last that is allowed, and `when` says for what pairs.
inline void require_kind(const hs_pair_cache& cache, NamedPair::Kind last, const char* when) {
  if (cache.pair_kind < NamedPair::face_vertex || cache.pair_kind > last) {
    refuse(HS_ERROR_ARGUMENT, "cache->pair_kind is %d; for %s it must be from 0 to %d", cache.pair_kind, when,
           last);
  }
}

/// `features` says in words what the shape has `count` of.
inline void require_index(std::int32_t index, int count, const char* name, const char* features) {
  if (index < 0 || index >= count) {
    refuse(HS_ERROR_ARGUMENT, "cache->%s is %d; the shape has %d %s", name, index, count, features);
  }
}

/// What is remembered but for a proof.
inline void write_cache(std::int32_t state, const NamedPair& pair, hs_pair_cache& cache) {
  cache.state = state;
  cache.pair_kind = pair.kind;
  cache.feature_a = pair.a;
  cache.feature_b = pair.b;
  cache.shapes = 0;
}

}  // namespace halfspace::capi
