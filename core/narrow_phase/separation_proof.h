#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>

#include "geometry/tolerances.h"
#include "narrow_phase/posed_pair.h"
#include "simd/two_lanes.h"

namespace halfspace {

/// A proof that two shapes remain separated after displacements: the distance of their centroids along a
/// normal exceeded their common reach in their orientations at that time. Stored by the host, with other
/// data.
template <class Proof>
concept SeparationProof = requires(Proof& proof) {
  { (proof.shapes) } -> std::same_as<std::uint64_t&>;    // their fingerprint_of(); 0 without a proof
  { (proof.reach) } -> std::same_as<double&>;            // upper bound, of both together along the normal
  { (proof.normal) } -> std::same_as<double(&)[3]>;      // unit, from a to b
  { (proof.rotation_a) } -> std::same_as<double(&)[4]>;  // quaternions
  { (proof.rotation_b) } -> std::same_as<double(&)[4]>;
};

/// The distance from a's centroid to b's along a unit vector.
template <int D>
double distance_along(const double normal[3], const PosedPair<D>& posed) {
  const double *a = posed.at_a.position, *b = posed.at_b.position;
  const TwoLanes along = (load_two(b) - load_two(a)) * load_two(normal);
  return D == 2 ? along[0] + along[1] : along[0] + along[1] + (b[2] - a[2]) * normal[2];
}

/// Upper bound of the reach of two shapes towards each other along the normal of their separation. Fewer than
/// 32 rounding errors occur between the poses and the gap, of numbers up to the distance of the centroids and
/// the radii. At large distances, where these exceed the reach, the radii are the bound.
template <int D>
double reach_of(const PosedPair<D>& posed, const double normal[3], double gap) {
  const double *a = posed.at_a.position, *b = posed.at_b.position;
  const double radii = posed.a.bounding_radius() + posed.b.bounding_radius();
  const TwoLanes way = abs(load_two(b) - load_two(a));
  const double size = radii + way[0] + way[1] + (D == 2 ? 0 : std::abs(b[2] - a[2]));
  const double reach = distance_along(normal, posed) - gap + place_rounding * size;
  return std::min(reach, (1 + largest_fault) * radii);
}

/// Stores a proof from the gap along a normal.
template <int D, SeparationProof Proof>
void keep_proof(const PosedPair<D>& posed, const double normal[3], double gap, Proof& proof) {
  proof.shapes = fingerprint_of(posed);
  proof.reach = reach_of(posed, normal, gap);
  std::copy_n(normal, 3, proof.normal);
  std::copy_n(posed.at_a.quaternion, 4, proof.rotation_a);
  std::copy_n(posed.at_b.quaternion, 4, proof.rotation_b);
}

/// Lower bound of the gap at these poses. A rotation by an angle displaces the points of a block by up to
/// 2 R sin(angle / 2), and its quaternion by 2 sin(angle / 4): the reach grows by at most 2 R times the
/// latter, summed over the components, and by a little more as quaternions may deviate from unit norm.
/// Translation is exact.
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

/// The gap if it still proves separation by more than the margin, else 0. Invalid poses prove nothing, nor do
/// poses in 2D whose quaternions rotate about z only to rounding.
template <int D, SeparationProof Proof>
[[gnu::always_inline]] inline double proven_gap(const PosedPair<D>& posed, const Proof& proof,
                                                double margin) {
  if (proof.shapes != fingerprint_of(posed)) return 0;
  const double gap = gap_left(posed, proof);
  const bool proves = gap > margin && gap < HUGE_VAL && are_tolerable<D>(posed.at_a, posed.at_b);
  return proves ? gap : 0;
}

}  // namespace halfspace
