#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "contact.h"
#include "detect/contact.h"
#include "geometry/two_lanes.h"
#include "halfspace/contact.h"
#include "halfspace/pair.h"
#include "posed_pair.h"

namespace halfspace::capi {

/// Odd, hence never 0; other for the same shapes swapped.
inline std::uint64_t fingerprint_of(const hs_shape& a, const hs_shape& b) {
  return a.fingerprint + 2 * b.fingerprint;
}

/// The remembered pair, not checked. Without a branch, as its owner is as good as random.
inline PotentialPair<2> pair_in(const hs_pair_cache& cache, int edges_of_a) {
  const std::int32_t owner = cache.edge >= edges_of_a;
  return {owner, cache.edge - owner * edges_of_a, cache.vertex};
}

/// Along the normal of a separated pair the centroids are farther apart than the shapes reach together. That
/// the cache keeps.
inline void keep_proof(const PosedPair& posed, const hs_contact& separated, hs_pair_cache& proof) {
  const auto& [a, at_a, b, at_b] = posed;
  const TwoLanes along = (two_at(at_b.position) - two_at(at_a.position)) * two_at(separated.normal);
  proof.shapes = fingerprint_of(a, b);
  proof.reach = (along[0] + along[1]) - separated.gap;
  std::copy_n(separated.normal, 3, proof.normal);
  std::copy_n(at_a.rotation, 4, proof.rotation_a);
  std::copy_n(at_b.rotation, 4, proof.rotation_b);
}

/// What the poses leave of the gap, at least. A block that turns by an angle moves none of its points by more
/// than 2 R sin(angle / 2), and its quaternion by 2 sin(angle / 4): the reach grows by at most 2 R times the
/// latter, here summed over the components, and by a little more as quaternions may be off unit length.
/// Translation counts as it is.
inline double gap_left(const PosedPair& posed, const hs_pair_cache& proof) {
  const auto& [a, at_a, b, at_b] = posed;
  const TwoLanes along = (two_at(at_b.position) - two_at(at_a.position)) * two_at(proof.normal);
  const TwoLanes turned = sums(magnitude(two_at(at_a.rotation + 2) - two_at(proof.rotation_a + 2)),
                               magnitude(two_at(at_b.rotation + 2) - two_at(proof.rotation_b + 2)));
  const TwoLanes moved = turned * TwoLanes{a.shape.bounding_radius(), b.shape.bounding_radius()};
  constexpr double points_per_quaternion = 2 * (1 + largest_fault);
  return ((along[0] + along[1]) - proof.reach) - points_per_quaternion * (moved[0] + moved[1]);
}

/// The answer when the pair is still proven to be separated. Poses that are to be refused prove nothing, nor
/// do those that are not finite, or whose quaternions turn about z but for rounding.
inline bool answer_by_proof(const PosedPair& posed, const hs_pair_cache& proof, hs_contact& out) {
  if (proof.state != PairMemory<2>::separated || proof.shapes != fingerprint_of(posed.a, posed.b))
    return false;
  if (!turn_exactly_about_z(posed.at_a, posed.at_b)) return false;
  const double gap = gap_left(posed, proof);
  if (!(gap > 0 && gap < HUGE_VAL)) return false;
  if (!is_tolerable(turns_about_z(posed.at_a, posed.at_b).fault)) return false;
  const PotentialPair<2> pair = pair_in(proof, posed.a.shape.vertex_count());
  write_separation(pair, {proof.normal[0], proof.normal[1]}, gap, out);
  return true;
}

}  // namespace halfspace::capi
