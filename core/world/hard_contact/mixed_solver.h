#pragma once

#include "world/hard_contact/contact_constraint.h"
#include "world/hard_contact/contact_groups.h"
#include "world/hard_contact/impulse_solver.h"

namespace halfspace {

/// Solves the manifolds of rigid blocks and the points of others together, where blocks have both: sweeps
/// over all of them are one iteration, accelerated by one conjugate direction.
template <int D>
class MixedSolver {
 public:
  MixedSolver(const Blocks<D>& blocks, Memory* memory)
      : blocks_(blocks), groups_(memory), start_(memory), shared_(memory), before_(memory) {}

  /// Takes the memory of problems of these contacts, with these rows or other friction rows.
  void reserve(const ImpulseProblem<D>& problem) {
    groups_.arrange(problem);
    start_.reserve(max_rows(problem));
  }
  /// Solves from no changes, and motions of the problem without any impulses. The impulses of both are the
  /// start and the result.
  ImpulseResult solve(ImpulseProblem<D>& problem, std::span<ContactConstraint<D>> points,
                      VelocityChange<D>& changes, const ImpulseSettings& settings, int max_sweeps);

  /// Keeps the impulses of manifolds for return_to_start().
  void keep_start(const ImpulseProblem<D>& problem);
  /// Restores them, and the impulses of points from before the last solve() of a single sweep.
  void return_to_start(ImpulseProblem<D>& problem, std::span<ContactConstraint<D>> points) const;
  /// The velocity that the last sweep changed at manifolds; in the first one, after the points'.
  double change_of_manifolds() const { return of_manifolds_; }
  /// Rigid blocks that had points in the last solution.
  std::span<const std::size_t> shared() const { return shared_; }
  void forget_shared() { shared_.clear(); }

 private:
  struct MixedRows;
  void find_shared(const ImpulseProblem<D>& problem, std::span<const ContactConstraint<D>> points);
  void tell_points(VelocityChange<D>& changes) const;
  void tell_manifolds(const VelocityChange<D>& changes);

  const Blocks<D>& blocks_;
  ContactGroups<D> groups_;
  double of_manifolds_ = 0;
  Array<double> start_;           // impulses of manifolds
  Array<std::size_t> shared_;     // rigid blocks that have points
  Array<BlockMotion<D>> before_;  // their motions without impulses
};

extern template class MixedSolver<2>;
extern template class MixedSolver<3>;

}  // namespace halfspace
