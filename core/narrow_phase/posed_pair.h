#pragma once

#include "geometry/shape.h"
#include "narrow_phase/contact.h"
#include "narrow_phase/frames.h"

namespace halfspace {

/// Two shapes of one dimension and where they are.
template <int D>
struct PosedPair {
  const Shape<D>& a;
  GivenPose at_a;
  const Shape<D>& b;
  GivenPose at_b;
};

/// Odd, hence never 0; other for the same shapes swapped.
template <int D>
std::uint64_t fingerprint_of(const PosedPair<D>& posed) {
  return posed.a.fingerprint() + 2 * posed.b.fingerprint();
}

/// The questions that a host may ask of one pair. Polyhedra take the defaults of what is said here.
struct PairOptions : DetectOptions {
  double margin = 0;        // blocks with no gap above it are in contact
  bool with_region = true;  // else a contact is its pair alone
};

}  // namespace halfspace
