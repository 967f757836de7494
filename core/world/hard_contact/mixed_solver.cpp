#include "world/hard_contact/mixed_solver.h"

#include <algorithm>

#include "world/hard_contact/stall.h"

namespace halfspace {

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
                                    VelocityChange<D>& changes, const ImpulseSettings& settings,
                                    int max_sweeps) {
  find_shared(problem, points);
  // Each side computes with motions of its own, and takes over those of shared blocks from the other.
  const auto tell_points = [&] {
    for (std::size_t k = 0; k < shared_.size(); ++k)
      changes.set_motion(shared_[k], groups_.motion(shared_[k]) - before_[k]);
  };
  const auto tell_manifolds = [&] {
    for (std::size_t k = 0; k < shared_.size(); ++k) {
      BlockMotion<D> motion = before_[k];
      motion += changes.of_motion(shared_[k]);
      groups_.set_motion(shared_[k], motion);
    }
  };
  ConstraintSweeps<D> sweeps(points, changes);
  groups_.take(problem);
  double fastest = groups_.begin(groups_.all());
  tell_points();
  fastest = std::max(fastest, sweeps.begin());
  tell_manifolds();
  ConjugateDirection direction;
  Stall stall;
  ImpulseResult result;
  for (int i = 1; i <= max_sweeps; ++i) {
    const bool is_forwards = i % 2 == 0;
    double of_points = 0;
    const auto sweep_points = [&] {
      of_points = sweeps.sweep(!is_forwards);
      tell_manifolds();
    };
    if (!is_forwards) sweep_points();
    of_manifolds_ = groups_.sweep(groups_.all(), !is_forwards);
    tell_points();
    if (is_forwards) sweep_points();
    const double changed = std::max(of_manifolds_, of_points);
    fastest = std::max(fastest, changed);
    result = {i, changed, changed <= settings.tolerance_for(fastest), fastest};
    if (is_balanced(result) || stall.is_reached(changed)) break;
    if (!is_forwards) continue;
    direction.update(groups_.squared_change(groups_.all()) + sweeps.squared_change());
    groups_.accelerate(groups_.all(), direction);
    tell_points();
    sweeps.accelerate(direction);
    tell_manifolds();
  }
  groups_.give(groups_.all(), problem);
  return result;
}

template <int D>
void MixedSolver<D>::keep_start(const ImpulseProblem<D>& problem) {
  start_.clear();
  for (const ImpulseRow<D>& row : problem.rows) start_.push_back(row.impulse);
}

template <int D>
void MixedSolver<D>::return_to_start(ImpulseProblem<D>& problem,
                                     std::span<ContactConstraint<D>> points) const {
  for (std::size_t i = 0; i < start_.size(); ++i) problem.rows[i].impulse = start_[i];
  for (ContactConstraint<D>& at : points) at.impulse = at.previous_impulse;
}

template class MixedSolver<2>;
template class MixedSolver<3>;

}  // namespace halfspace
