#include "world/hard_contact/mixed_solver.h"

#include <algorithm>

#include "world/hard_contact/stall.h"

namespace halfspace {
namespace {

/// Points take many sweeps where light nodes bear heavy blocks.
constexpr int min_limit = 1000;

}  // namespace

template <int D>
void MixedSolver<D>::find_shared(const ImpulseProblem<D>& problem,
                                 std::span<const ContactConstraint<D>> points) {
  shared_.clear();
  for (const ContactConstraint<D>& at : points) {
    for (const std::int32_t block : {at.a, at.b}) {
      const std::size_t mover = blocks_.mover_of(std::size_t(block));
      if (blocks_.kind[mover] == BlockKind::rigid) shared_.push_back(mover);
    }
  }
  std::sort(shared_.begin(), shared_.end());
  shared_.erase(std::unique(shared_.begin(), shared_.end()), shared_.end());
  before_.clear();
  for (const std::size_t block : shared_) before_.push_back(problem.motions[block]);
}

template <int D>
ImpulseResult MixedSolver<D>::solve(ImpulseProblem<D>& problem, std::span<ContactConstraint<D>> points,
                                    VelocityChange<D>& changes, const ImpulseSettings& settings) {
  find_shared(problem, points);
  // Each side computes with motions of its own, and takes over those of shared blocks from the other.
  const auto tell_points = [&] {
    for (std::size_t k = 0; k < shared_.size(); ++k)
      changes.set_motion(shared_[k], problem.motions[shared_[k]] - before_[k]);
  };
  const auto tell_manifolds = [&] {
    for (std::size_t k = 0; k < shared_.size(); ++k) {
      problem.motions[shared_[k]] = before_[k];
      problem.motions[shared_[k]] += changes.of_motion(shared_[k]);
    }
  };
  ConstraintSweeps<D> sweeps(points, changes);
  double fastest = solver_.begin(problem);
  tell_points();
  fastest = std::max(fastest, sweeps.begin());
  tell_manifolds();
  ConjugateDirection direction;
  Stall stall;
  ImpulseResult result;
  const int limit = std::max(settings.max_iterations, min_limit);
  for (int i = 1; i <= limit; ++i) {
    const bool is_backwards = i % 2 == 0;
    double changed = 0;
    for (const bool of_manifolds : {!is_backwards, is_backwards}) {
      changed =
          std::max(changed, of_manifolds ? solver_.sweep(problem, is_backwards) : sweeps.sweep(is_backwards));
      of_manifolds ? tell_points() : tell_manifolds();
    }
    fastest = std::max(fastest, changed);
    result = {i, changed, changed <= std::min(settings.tolerance_for(fastest), smallest_change * fastest)};
    if (result.has_converged || stall.is_reached(changed)) return result;
    if (!is_backwards) continue;
    direction.update(solver_.squared_change(problem) + sweeps.squared_change());
    solver_.accelerate(problem, direction);
    tell_points();
    sweeps.accelerate(direction);
    tell_manifolds();
  }
  return result;
}

template class MixedSolver<2>;
template class MixedSolver<3>;

}  // namespace halfspace
