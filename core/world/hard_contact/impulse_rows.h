#pragma once

#include <span>

#include "world/hard_contact/impulse_problem.h"
#include "world/hard_contact/manifold_search.h"

namespace halfspace {

/// The part of a face that touches.
template <int D>
struct Patch {
  Vector<D> center;  // from the centroid of a
  double radius;     // m, of the couple that even pressure gives: its bound over that of friction
  double area;       // m²
};

/// The middle of a manifold's points, about which the couple of friction is kept.
template <int D>
Vector<D> middle_of(const RigidContact<D>& at, const Arms<D>& arm) {
  Vector<D> sum = Vector<D>::Zero();
  for (int i = 0; i < at.manifold.count; ++i) sum += arm[std::size_t(i)];
  return sum / at.manifold.count;
}

/// The centre of the normal impulses, on the plane of the manifold.
template <int D>
Vector<D> center_of_impulses(const RigidContact<D>& at, const Arms<D>& arm);

/// Makes the rows of an impulse problem from manifolds, with the blocks where they are now: one row per
/// point, and friction at the centre of their impulses. Rows act on the compound of a part.
template <int D>
class ImpulseRows {
 public:
  ImpulseRows(const Model<D>& model, const ManifoldSearch<D>& search)
      : model_(model), blocks_(model.blocks), search_(search) {}

  /// Sets contacts, rows and masses. Impulses are those of the contacts; targets are 0.
  void build(std::span<PredictedContact<D>> contacts, ImpulseProblem<D>& problem);
  /// The same without friction. These blocks do not move.
  void build_normals(std::span<PredictedContact<D>> contacts, ImpulseProblem<D>& problem,
                     std::span<const std::size_t> immovable);

 private:
  void build_of_masses(std::span<PredictedContact<D>> contacts, ImpulseProblem<D>& problem,
                       bool with_friction);
  Patch<D> patch_of(const RigidContact<D>& at, const Arms<D>& arm) const;
  void set_inverse_masses(ImpulseProblem<D>& problem);

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  const ManifoldSearch<D>& search_;
};

extern template class ImpulseRows<2>;
extern template class ImpulseRows<3>;

}  // namespace halfspace
