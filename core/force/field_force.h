#pragma once

#include "force/potential_force.h"

namespace halfspace {

/// What one block's potential does to the other one, and in return to its owner.
template <int D>
struct FieldForce {
  Vector<D> force = Vector<D>::Zero();  // on the other block
  Tensor<D> virial_of_owner = Tensor<D>::Zero();
  Tensor<D> virial_of_other = Tensor<D>::Zero();
  double energy = 0;
};

/// Of both potentials, where the blocks share so much about this point.
template <int D>
PotentialForce<D> sum_of(const FieldForce<D>& by_a, const FieldForce<D>& by_b, const Vector<D>& centroid,
                         double content) {
  return {by_a.force - by_b.force,
          by_a.virial_of_owner + by_b.virial_of_other,
          by_a.virial_of_other + by_b.virial_of_owner,
          centroid,
          content,
          by_a.energy + by_b.energy};
}

}  // namespace halfspace
