#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// How two blocks move: velocities of their centroids, angular velocities and strain rates.
template <int D>
struct PairMotion {
  Vector<D> velocity;  // of b's centroid relative to a's
  Vector<D> to_b;
  Angular<D> spin_a;
  Angular<D> spin_b;
  const Tensor<D>* strain_rate_a = nullptr;  // of an affine block
  const Tensor<D>* strain_rate_b = nullptr;

  /// Velocity of b's material relative to a's at a point given from a's centroid.
  Vector<D> relative_at(const Vector<D>& p) const {
    Vector<D> relative = velocity + swept(spin_b, p - to_b) - swept(spin_a, p);
    if (strain_rate_a || strain_rate_b) {
      if (strain_rate_b) relative += *strain_rate_b * (p - to_b);
      if (strain_rate_a) relative -= *strain_rate_a * p;
    }
    return relative;
  }
};

}  // namespace halfspace
