#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "contact.h"
#include "halfspace/contact.h"
#include "halfspace/pair.h"
#include "narrow_phase/contact.h"
#include "pair_cache.h"
#include "posed_pair.h"
#include "simd/two_lanes.h"

namespace halfspace::capi {

/// Odd, hence never 0; other for the same shapes swapped.
inline std::uint64_t fingerprint_of(const hs_shape& a, const hs_shape& b) {
  return a.fingerprint + 2 * b.fingerprint;
}

/// Is there a proof, and of these shapes?
template <int D>
inline bool is_proven(const PosedPair<D>& posed, const hs_pair_cache& cache) {
  return cache.state == PairMemory<D>::separated && cache.shapes == fingerprint_of(posed.a, posed.b);
}

/// How far a unit vector leads from a's centroid to b's.
template <int D>
inline double distance_along(const double normal[3], const PosedPair<D>& posed) {
  const double *a = posed.at_a.position, *b = posed.at_b.position;
  const TwoLanes along = (two_at(b) - two_at(a)) * two_at(normal);
  return D == 2 ? along[0] + along[1] : along[0] + along[1] + (b[2] - a[2]) * normal[2];
}

/// How far two shapes reach towards each other along the normal on which they have been found separated, or
/// more. Fewer than 32 roundings lie between the poses and the gap, of numbers no larger than the way between
/// the centroids and the radii; and far apart, where these leave nothing of the reach, the radii bound it.
template <int D>
inline double reach_of(const PosedPair<D>& posed, const hs_contact& separated) {
  const double *a = posed.at_a.position, *b = posed.at_b.position;
  const double radii = posed.a.shape.bounding_radius() + posed.b.shape.bounding_radius();
  const TwoLanes way = magnitude(two_at(b) - two_at(a));
  const double size = radii + way[0] + way[1] + (D == 2 ? 0 : std::abs(b[2] - a[2]));
  const double reach = distance_along(separated.normal, posed) - separated.gap + 0x1p-48 * size;
  return std::min(reach, (1 + largest_fault) * radii);
}

/// Along the normal of a separated pair the centroids are farther apart than the shapes reach together. That
/// the cache keeps.
template <int D>
inline void keep_proof(const PosedPair<D>& posed, const hs_contact& separated, hs_pair_cache& proof) {
  proof.shapes = fingerprint_of(posed.a, posed.b);
  proof.reach = reach_of(posed, separated);
  std::copy_n(separated.normal, 3, proof.normal);
  std::copy_n(posed.at_a.rotation, 4, proof.rotation_a);
  std::copy_n(posed.at_b.rotation, 4, proof.rotation_b);
}

/// What the poses leave of the gap, at least. A block that turns by an angle moves none of its points by more
/// than 2 R sin(angle / 2), and its quaternion by 2 sin(angle / 4): the reach grows by at most 2 R times the
/// latter, here summed over the components, and by a little more as quaternions may be off unit length.
/// Translation counts as it is.
template <int D>
inline double gap_left(const PosedPair<D>& posed, const hs_pair_cache& proof) {
  const double *a = posed.at_a.rotation, *b = posed.at_b.rotation;
  TwoLanes turned = sums(magnitude(two_at(a + 2) - two_at(proof.rotation_a + 2)),
                         magnitude(two_at(b + 2) - two_at(proof.rotation_b + 2)));
  if (D == 3)
    turned += sums(magnitude(two_at(a) - two_at(proof.rotation_a)),
                   magnitude(two_at(b) - two_at(proof.rotation_b)));
  const TwoLanes moved = turned * TwoLanes{posed.a.shape.bounding_radius(), posed.b.shape.bounding_radius()};
  constexpr double points_per_quaternion = 2 * (1 + largest_fault);
  return (distance_along(proof.normal, posed) - proof.reach) - points_per_quaternion * (moved[0] + moved[1]);
}

/// Are both quaternions of unit length and both places near enough, as far as they have to be? False also for
/// NaN, and for some poses that are tolerable each by itself.
template <int D>
inline bool poses_are_tolerable(const hs_pose& a, const hs_pose& b) {
  if constexpr (D == 2) return are_tolerable(turns_about_z(a, b), a, b);
  const TwoLanes far_off = magnitude(two_at(a.position)) + magnitude(two_at(b.position));
  const double farthest = far_off[0] + far_off[1] + std::abs(a.position[2]) + std::abs(b.position[2]);
  return is_tolerable(TwoLanes{fault_of_quaternion(a.rotation), fault_of_quaternion(b.rotation)}) &&
         weight_far_off * farthest <= largest_fault;
}

/// The answer when the pair is still proven to be separated by more than the margin. Poses that are to be
/// refused prove nothing, nor do those in 2D whose quaternions turn about z but for rounding.
template <int D>
[[gnu::always_inline]] inline bool answer_by_proof(const PosedPair<D>& posed, const hs_pair_cache& proof,
                                                   hs_contact& out, double margin = 0) {
  if (!is_proven(posed, proof)) return false;
  const double gap = gap_left(posed, proof);
  if (!(gap > margin && gap < HUGE_VAL)) return false;
  if (!poses_are_tolerable<D>(posed.at_a, posed.at_b)) return false;
  write_separation<D>(pair_in(proof), Vector<D>(proof.normal), gap, out);
  return true;
}

}  // namespace halfspace::capi
