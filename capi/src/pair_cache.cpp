#include "pair_cache.h"

#include "narrow_phase/features.h"
#include "require.h"

namespace halfspace::capi {
namespace {

void require_state(const hs_pair_cache& cache) {
  if (cache.state < PairState::unknown || cache.state > PairState::touching) {
    refuse(HS_ERROR_ARGUMENT, "cache->state is %d; it must be 0, 1 or 2", cache.state);
  }
}

/// `last` is the last allowed kind; `when` names the pairs in the error text.
void require_kind(const hs_pair_cache& cache, NamedPair::Kind last, const char* when) {
  if (cache.pair_kind < NamedPair::face_vertex || cache.pair_kind > last) {
    refuse(HS_ERROR_ARGUMENT, "cache->pair_kind is %d; for %s it must be from 0 to %d", cache.pair_kind, when,
           last);
  }
}

/// The shape has `count` features; `features` is their name in the error text.
void require_index(std::int32_t index, int count, const char* name, const char* features) {
  if (!is_below(index, count)) {
    refuse(HS_ERROR_ARGUMENT, "cache->%s is %d; the shape has %d %s", name, index, count, features);
  }
}

void require_feature(std::int32_t index, Feature feature, const Shape<3>& shape, const char* name) {
  constexpr const char* words[] = {"vertices", "edges", "faces"};
  require_index(index, count_of(feature, shape.outline()), name, words[int(feature)]);
}

}  // namespace

PairCache<2> read_cache(const hs_pair_cache& cache, const PosedPair<2>& posed) {
  require_state(cache);
  if (cache.state == PairState::unknown) return {};
  require_kind(cache, NamedPair::vertex_face, "polygons");
  // A polygon has as many edges as vertices.
  require_index(cache.feature_a, posed.a.vertex_count(), "feature_a", "edges and as many vertices");
  require_index(cache.feature_b, posed.b.vertex_count(), "feature_b", "edges and as many vertices");
  return {PairState::State(cache.state), in_plane(pair_in(cache))};
}

PairCache<3> read_cache(const hs_pair_cache& cache, const PosedPair<3>& posed) {
  require_state(cache);
  if (cache.state == PairState::unknown) return {};
  const bool is_separated = cache.state == PairState::separated;
  if (is_separated) {
    require_kind(cache, NamedPair::vertex_vertex, "separated polyhedra");
  } else {
    require_kind(cache, NamedPair::edge_edge, "polyhedra in contact");
  }
  const FeaturesOfPair& features = features_of_kind[cache.pair_kind];
  require_feature(cache.feature_a, features.a, posed.a, "feature_a");
  require_feature(cache.feature_b, features.b, posed.b, "feature_b");
  PairCache<3> witness{PairState::State(cache.state), pair_in(cache)};
  if (is_separated) {
    // The separating plane of other shapes is ignored.
    if (cache.shapes != fingerprint_of(posed)) return {};
    for (const double component : cache.normal) require_finite(component, "cache->normal");
    witness.proof = Vector<3>(cache.normal);
  }
  return witness;
}

}  // namespace halfspace::capi
