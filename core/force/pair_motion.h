#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// The strain rates of two blocks; zero for one that is not affine.
template <int D>
struct StrainRates {
  Tensor<D> of_a = Tensor<D>::Zero();
  Tensor<D> of_b = Tensor<D>::Zero();
};

/// How two blocks move: velocities of their centroids, angular velocities and strain rates.
template <int D>
struct PairMotion {
  Vector<D> velocity;  // of b's centroid relative to a's
  Vector<D> to_b;
  Angular<D> spin_a;
  Angular<D> spin_b;
  const StrainRates<D>* strain_rates = nullptr;  // none of two rigid blocks

  /// Velocity of b's material relative to a's at a point given from a's centroid.
  Vector<D> relative_at(const Vector<D>& p) const {
    Vector<D> relative = velocity + swept(spin_b, p - to_b) - swept(spin_a, p);
    if (strain_rates) {
      relative += strain_rates->of_b * (p - to_b);
      relative -= strain_rates->of_a * p;
    }
    return relative;
  }

  /// How much faster the blocks open along a unit direction from place to place across it.
  Vector<D> opening_slope(const Vector<D>& direction) const {
    Vector<D> slope = -swept(Angular<D>(spin_b - spin_a), direction);
    if (strain_rates) {
      slope += (strain_rates->of_b - strain_rates->of_a).transpose() * direction;
      slope -= direction.dot(slope) * direction;
    }
    return slope;
  }
};

}  // namespace halfspace
