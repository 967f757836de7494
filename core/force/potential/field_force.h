#pragma once

#include "force/potential/potential_force.h"

namespace halfspace {

/// The force of one block's potential, the owner's, on the other block, and its reaction on the owner. A sum
/// over the cells of their overlap, each with one face of the owner as its nearest.
///
/// When the owner moves, the depth changes by the motion of its face at the foot of the cell's centroid: the
/// force on the owner acts there. When the other block moves, the cell moves with it, and its compression
/// reduces the energy in it: its virial has an isotropic part.
template <int D>
struct FieldForce {
  Vector<D> force = Vector<D>::Zero();          // on the other block
  Tensor<D> at_cells = Tensor<D>::Zero();       // force times position^T, at the cells' centroids
  Tensor<D> cells_to_feet = Tensor<D>::Zero();  // force times vector^T, from the centroids to their feet
  double energy = 0;

  /// Adds a cell of the given area or volume, the moment of its position, and the energy of the depth behind
  /// the nearest face.
  void add_cell(double content, const Vector<D>& moment, double energy_in_cell, const Vector<D>& normal) {
    force += content * normal;
    at_cells += normal * moment.transpose();
    cells_to_feet += energy_in_cell * normal * normal.transpose();
    energy += energy_in_cell;
  }

  Tensor<D> virial_of_owner(const Vector<D>& centroid) const {
    return force * centroid.transpose() - at_cells - cells_to_feet;
  }
  Tensor<D> virial_of_other(const Vector<D>& centroid) const {
    return at_cells - force * centroid.transpose() - energy * Tensor<D>::Identity();
  }
};

/// The force of both potentials. The centroid of the overlap is relative to that of a.
template <int D>
PotentialForce<D> sum_of(const FieldForce<D>& by_a, const FieldForce<D>& by_b, const Vector<D>& centroid_a,
                         const Vector<D>& centroid_b, const Vector<D>& centroid, double content) {
  return {by_a.force - by_b.force,
          by_a.virial_of_owner(centroid_a) + by_b.virial_of_other(centroid_a),
          by_a.virial_of_other(centroid_b) + by_b.virial_of_owner(centroid_b),
          centroid,
          content,
          by_a.energy + by_b.energy};
}

}  // namespace halfspace
