#pragma once

#include "world/hard_contact/contact_constraint.h"
#include "world/hard_contact/impulse_solver.h"

namespace halfspace {

/// Solves the manifolds of rigid blocks and the points of others together, where blocks have both: sweeps
/// over all of them are one iteration, accelerated by one conjugate direction.
template <int D>
class MixedSolver {
 public:
  MixedSolver(const Blocks<D>& blocks, Memory* memory)
      : blocks_(blocks), solver_(memory), shared_(memory), before_(memory) {}

  /// From no changes, and motions of the problem without any impulses. The impulses of both are the start and
  /// the result.
  ImpulseResult solve(ImpulseProblem<D>& problem, std::span<ContactConstraint<D>> points,
                      VelocityChange<D>& changes, const ImpulseSettings& settings);

 private:
  void find_shared(const ImpulseProblem<D>& problem, std::span<const ContactConstraint<D>> points);

  const Blocks<D>& blocks_;
  ImpulseSolver<D> solver_;
  Array<std::size_t> shared_;     // rigid blocks that have points
  Array<BlockMotion<D>> before_;  // of these, without impulses
};

extern template class MixedSolver<2>;
extern template class MixedSolver<3>;

}  // namespace halfspace
