#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// How two blocks move: velocities of their centroids and angular velocities.
template <int D>
struct PairMotion {
  Vector<D> velocity;  // of b's centroid relative to a's
  Vector<D> to_b;
  Angular<D> spin_a;
  Angular<D> spin_b;

  /// Velocity of b's material relative to a's at a point given from a's centroid.
  Vector<D> relative_at(const Vector<D>& p) const {
    return velocity + swept(spin_b, p - to_b) - swept(spin_a, p);
  }
};

}  // namespace halfspace
