#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// The velocity gradients of two blocks by strain; zero for blocks that are not affine.
template <int D>
struct StrainRates {
  Tensor<D> of_a = Tensor<D>::Zero();
  Tensor<D> of_b = Tensor<D>::Zero();
};

/// The relative motion of two blocks: velocities of their centroids, spins and strain rates.
template <int D>
struct PairMotion {
  Vector<D> velocity;  // of b's centroid relative to a's
  Vector<D> to_b;
  Angular<D> spin_a;
  Angular<D> spin_b;
  const StrainRates<D>* strain_rates = nullptr;  // null for two rigid blocks

  /// Half of the mean rotation of both blocks in a time, if spins are mean spins (theory.md, friction).
  Angular<D> half_turn(double elapsed) const { return 0.25 * elapsed * (spin_a + spin_b); }

  /// Velocity of b relative to a at a material point, given from a's centroid.
  Vector<D> relative_at(const Vector<D>& p) const {
    Vector<D> relative = velocity + swept(spin_b, p - to_b) - swept(spin_a, p);
    if (strain_rates) {
      relative += strain_rates->of_b * (p - to_b);
      relative -= strain_rates->of_a * p;
    }
    return relative;
  }

  /// The gradient, across a unit direction, of the opening velocity along it.
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
