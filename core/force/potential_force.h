#pragma once

#include "geometry/outline.h"

namespace halfspace {

/// What the potentials of two overlapping blocks do to each other, for k_n / H = 1 (Zheng et al. 2020,
/// section 3).
template <int D>
struct PotentialForce {
  Vector<D> force = Vector<D>::Zero();     // on b, opposite on a
  Angular<D> moment = Angular<D>::Zero();  // of it about the centroid of a
  double energy = 0;                       // falls along the force: that is its gradient
};

/// Room to work in. Once it has grown to the largest blocks it asks for no more memory.
struct PotentialRoom {
  explicit PotentialRoom(Memory* memory) : near(memory), intersection(memory), cell(memory), cut(memory) {}

  Array<std::int32_t> near;  // edges that can be the nearest one to some point of the other block
  Array<Vector<2>> intersection;
  Array<Vector<2>> cell;
  Array<Vector<2>> cut;
};

/// A point inside a block has its distance to the nearest edge as potential; what two blocks have in common
/// is pushed down both. The paper integrates the potential over the outline of the intersection, piece by
/// piece between demarcation points. By the divergence theorem that is the integral of its gradient over the
/// intersection, and the gradient is constant where one edge is the nearest: area times normal, cell by cell.
/// The moment acts at the cells' centroids, and the energy is area times depth there. Cost grows with the
/// product of the numbers of edges; of cells there are but the few whose edges the other block reaches.
PotentialForce<2> potential_force(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                                  PotentialRoom& room);

}  // namespace halfspace
