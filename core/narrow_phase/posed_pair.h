#pragma once

#include "geometry/shape.h"
#include "narrow_phase/contact.h"
#include "narrow_phase/frames.h"

namespace halfspace {

/// Two shapes with their poses.
template <int D>
struct PosedPair {
  const Shape<D>& a;
  GivenPose at_a;
  const Shape<D>& b;
  GivenPose at_b;
};

/// Odd, hence never 0; changes when the shapes are swapped.
template <int D>
std::uint64_t fingerprint_of(const PosedPair<D>& posed) {
  return posed.a.fingerprint() + 2 * posed.b.fingerprint();
}

/// Options of a search of one pair. For polyhedra only defaults of these are supported.
struct PairOptions : DetectOptions {
  double margin = 0;        // a pair with a gap above it is separated
  bool with_region = true;  // false: a contact is its pair alone
};

}  // namespace halfspace
