#pragma once

#include <iterator>

#include "geometry/outline.h"
#include "narrow_phase/contact.h"

namespace halfspace {

/// The features of a potential pair in 3D.
enum class Feature { vertex, edge, face };
struct FeaturesOfPair {
  Feature a;
  Feature b;
};

/// Indexed by the kind of pair.
constexpr FeaturesOfPair features_of_kind[] = {{Feature::face, Feature::vertex},
                                               {Feature::vertex, Feature::face},
                                               {Feature::edge, Feature::edge},
                                               {Feature::vertex, Feature::vertex}};

inline int count_of(Feature feature, const Outline<3>& block) {
  const int counts[] = {block.vertex_count(), block.edge_count(), block.face_count()};
  return counts[int(feature)];
}

inline bool is_below(std::int32_t index, std::int32_t count) { return index >= 0 && index < count; }

/// Does a pair from a snapshot have valid indices of features?
inline bool names_features(const PotentialPair<2>& pair, const Outline<2>& a, const Outline<2>& b) {
  if (pair.owner != 0 && pair.owner != 1) return false;
  return is_below(pair.edge, (pair.owner == 0 ? a : b).count) &&
         is_below(pair.vertex, (pair.owner == 0 ? b : a).count);
}
inline bool names_features(const PotentialPair<3>& pair, const Outline<3>& a, const Outline<3>& b) {
  if (!is_below(pair.kind, int(std::size(features_of_kind)))) return false;
  const FeaturesOfPair& features = features_of_kind[pair.kind];
  return is_below(pair.a, count_of(features.a, a)) && is_below(pair.b, count_of(features.b, b));
}

}  // namespace halfspace
