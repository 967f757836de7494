#include "contact.h"
#include "detection.h"
#include "narrow_phase/pair.h"
#include "narrow_phase/space/minkowski_difference.h"
#include "pair_cache.h"

namespace halfspace::capi {
namespace {

/// Which features a pair of each kind has, and what there is of them.
enum class Feature { vertex, edge, face };
struct FeaturesOfPair {
  Feature a;
  Feature b;
};
constexpr FeaturesOfPair features_of_kind[] = {{Feature::face, Feature::vertex},
                                               {Feature::vertex, Feature::face},
                                               {Feature::edge, Feature::edge},
                                               {Feature::vertex, Feature::vertex}};

void require_feature(std::int32_t index, Feature feature, const ShapeHandle<3>& block, const char* name) {
  const Shape<3>& s = block.shape;
  switch (feature) {
    case Feature::vertex:
      return require_index(index, s.vertex_count(), name, "vertices");
    case Feature::edge:
      return require_index(index, s.edge_count(), name, "edges");
    case Feature::face:
      return require_index(index, s.face_count(), name, "faces");
  }
}

/// Of separated blocks without their normal. What has kept other shapes apart is not remembered.
PairMemory<3> read_cache(const hs_pair_cache& cache, const PosedPair<3>& posed) {
  require_state(cache);
  if (cache.state == PairMemory<3>::unknown) return {};
  if (cache.state == PairMemory<3>::separated) {
    require_kind(cache, NamedPair::vertex_vertex, "separated polyhedra");
  } else {
    require_kind(cache, NamedPair::edge_edge, "polyhedra in contact");
  }
  const FeaturesOfPair& features = features_of_kind[cache.pair_kind];
  require_feature(cache.feature_a, features.a, posed.a, "feature_a");
  require_feature(cache.feature_b, features.b, posed.b, "feature_b");
  if (cache.state == PairMemory<3>::separated) {
    if (!is_proven(posed, cache)) return {};
    for (const double component : cache.normal) require_finite(component, "cache->normal");
  }
  return {PairMemory<3>::State(cache.state), pair_in(cache)};
}

/// Does the plane of the proof, though it may have been worn out by motion, still lie between? Along its
/// normal, given in the frame of a, the blocks reach so far now.
double gap_along(const Vector<3>& normal, const Outline<3>& a, const Outline<3>& b,
                 const PlacementInSpace& at) {
  MinkowskiDifference<Rotation<3>> difference(a, b, at.to_b, at.b_in_a);
  return normal.dot(difference.deepest_along(normal).at);
}

/// The cache may be NULL.
void answer_separated(const NamedPair& pair, const Vector<3>& normal, double gap, const PosedPair<3>& posed,
                      hs_pair_cache* cache, hs_contact& out) {
  write_separation<3>(pair, normal, gap, out);
  if (!cache) return;
  write_cache(PairMemory<3>::separated, pair, *cache);
  keep_proof(posed, out, *cache);
}

}  // namespace

void judge(const PosedPair<3>& posed, const PairOptions& options, hs_pair_cache* cache, hs_contact& out) {
  const PlacementInSpace at = read_placement(posed.at_a, posed.at_b);
  const Outline<3>& a = posed.a.shape.outline();
  const Outline<3>& b = posed.b.shape.outline();
  PairMemory<3> memory;
  if (cache) memory = read_cache(*cache, posed);
  if (memory.state == PairMemory<3>::separated) {
    const Vector<3> normal(cache->normal), seen_from_a = at.frame_of_a.inverse() * normal;
    const double gap = gap_along(seen_from_a, a, b, at);
    if (gap > 0) return answer_separated(memory.pair, normal, gap, posed, cache, out);
    memory = memory_of(Separation<3>{gap, memory.pair, seen_from_a});
  }
  const Separation<3> found = find_separation(a, b, at.to_b, at.b_in_a);
  if (found.gap > 0)
    return answer_separated(found.pair, at.frame_of_a * found.normal, found.gap, posed, cache, out);

  Contact<3> contact;
  describe_overlap<3>(a, {b, at.b_in_a}, at.to_b, found.pair, options, memory, contact);
  write_contact(contact, at.frame_of_a, Vector<3>(posed.at_a.position), out);
  if (cache) write_cache(memory.state, memory.pair, *cache);
}

void require_readable(const PosedPair<3>& posed, const hs_pair_cache* cache) {
  read_placement(posed.at_a, posed.at_b);
  if (cache) read_cache(*cache, posed);
}

}  // namespace halfspace::capi
