#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>

#include "narrow_phase/posed_pair.h"
#include "simd/two_lanes.h"

namespace halfspace {

/// A proof that two shapes stay separated after they have moved: along the normal their centroids were
/// farther apart than they reach together, as they were turned then. The host keeps it, with other things of
/// its own.
template <class Proof>
concept SeparationProof = requires(Proof& proof) {
  { (proof.shapes) } -> std::same_as<std::uint64_t&>;    // fingerprint_of() these; 0 if there is no proof
  { (proof.reach) } -> std::same_as<double&>;            // of both together along the normal, or more
  { (proof.normal) } -> std::same_as<double(&)[3]>;      // unit, from a to b
  { (proof.rotation_a) } -> std::same_as<double(&)[4]>;  // quaternions
  { (proof.rotation_b) } -> std::same_as<double(&)[4]>;
};

/// How far a unit vector leads from a's centroid to b's.
template <int D>
double distance_along(const double normal[3], const PosedPair<D>& posed) {
  const double *a = posed.at_a.position, *b = posed.at_b.position;
  const TwoLanes along = (load_two(b) - load_two(a)) * load_two(normal);
  return D == 2 ? along[0] + along[1] : along[0] + along[1] + (b[2] - a[2]) * normal[2];
}

/// How far two shapes reach towards each other along the normal on which they have been found separated, or
/// more. Fewer than 32 roundings lie between the poses and the gap, of numbers no larger than the way between
/// the centroids and the radii; and far apart, where these leave nothing of the reach, the radii bound it.
template <int D>
double reach_of(const PosedPair<D>& posed, const double normal[3], double gap) {
  const double *a = posed.at_a.position, *b = posed.at_b.position;
  const double radii = posed.a.bounding_radius() + posed.b.bounding_radius();
  const TwoLanes way = abs(load_two(b) - load_two(a));
  const double size = radii + way[0] + way[1] + (D == 2 ? 0 : std::abs(b[2] - a[2]));
  const double reach = distance_along(normal, posed) - gap + 0x1p-48 * size;
  return std::min(reach, (1 + largest_fault) * radii);
}

/// Keeps a proof from the gap by which a pair has been found separated along a normal.
template <int D, SeparationProof Proof>
void keep_proof(const PosedPair<D>& posed, const double normal[3], double gap, Proof& proof) {
  proof.shapes = fingerprint_of(posed);
  proof.reach = reach_of(posed, normal, gap);
  std::copy_n(normal, 3, proof.normal);
  std::copy_n(posed.at_a.quaternion, 4, proof.rotation_a);
  std::copy_n(posed.at_b.quaternion, 4, proof.rotation_b);
}

/// The gap that is left at these poses, at least. A block that turns by an angle moves none of its points by
/// more than 2 R sin(angle / 2), and its quaternion by 2 sin(angle / 4): the reach grows by at most 2 R times
/// the latter, here summed over the components, and by a little more as quaternions may be off unit length.
/// Translation counts as it is.
template <int D, SeparationProof Proof>
[[gnu::always_inline]] inline double gap_left(const PosedPair<D>& posed, const Proof& proof) {
  const double *a = posed.at_a.quaternion, *b = posed.at_b.quaternion;
  TwoLanes turned = sums(abs(load_two(a + 2) - load_two(proof.rotation_a + 2)),
                         abs(load_two(b + 2) - load_two(proof.rotation_b + 2)));
  if (D == 3)
    turned +=
        sums(abs(load_two(a) - load_two(proof.rotation_a)), abs(load_two(b) - load_two(proof.rotation_b)));
  const TwoLanes moved = turned * TwoLanes{posed.a.bounding_radius(), posed.b.bounding_radius()};
  constexpr double points_per_quaternion = 2 * (1 + largest_fault);
  return (distance_along(proof.normal, posed) - proof.reach) - points_per_quaternion * (moved[0] + moved[1]);
}

/// The gap that is left when it still proves the pair separated by more than the margin, else 0. Poses that
/// are to be refused prove nothing, nor do those in the plane whose quaternions turn about z but for
/// rounding.
template <int D, SeparationProof Proof>
[[gnu::always_inline]] inline double proven_gap(const PosedPair<D>& posed, const Proof& proof,
                                                double margin) {
  if (proof.shapes != fingerprint_of(posed)) return 0;
  const double gap = gap_left(posed, proof);
  const bool proves = gap > margin && gap < HUGE_VAL && are_tolerable<D>(posed.at_a, posed.at_b);
  return proves ? gap : 0;
}

}  // namespace halfspace
