#pragma once

#include <span>

#include "world/hard_contact/impulse_problem.h"
#include "world/hard_contact/manifold_search.h"

namespace halfspace {

/// Where friction acts.
template <int D>
struct Patch {
  Vector<D> center;  // from the centroid of a
  double radius;     // m, of the couple that even pressure gives: its bound over that of friction
  double area;       // m²
};

/// Makes the rows of an impulse problem from manifolds, with the blocks where they are now: one row per
/// point, and friction at the centroid of the points that touch. Rows act on the compound of a part.
template <int D>
class ImpulseRows {
 public:
  ImpulseRows(const Model<D>& model, const ManifoldSearch<D>& search)
      : model_(model), blocks_(model.blocks), search_(search) {}

  /// Sets contacts, rows and masses. Impulses are those of the contacts; targets are 0.
  /// These blocks do not move.
  void build(std::span<const PlannedContact<D>> contacts, ImpulseProblem<D>& problem,
             std::span<const std::size_t> immovable = {});

  /// `arm`: of each point, from the centroid of a.
  Patch<D> patch_of(const RigidContact<D>& at,
                    const std::array<Vector<D>, max_manifold_points<D>>& arm) const;

 private:
  void set_inverse_masses(ImpulseProblem<D>& problem);

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  const ManifoldSearch<D>& search_;
};

extern template class ImpulseRows<2>;
extern template class ImpulseRows<3>;

}  // namespace halfspace
