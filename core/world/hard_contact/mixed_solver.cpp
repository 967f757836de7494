#include "world/hard_contact/mixed_solver.h"

#include <algorithm>

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

/// Manifolds, then points. Each side computes with motions of its own, and takes over those of shared blocks
/// from the other.
template <int D>
struct MixedSolver<D>::MixedRows {
  double begin() {
    const double of_manifolds = manifolds.groups.begin(manifolds.part);
    solver.tell_points(changes);
    const double of_points = points.begin();
    solver.tell_manifolds(changes);
    return std::max(of_manifolds, of_points);
  }
  double sweep(bool is_backwards) {
    double of_points = 0;
    if (is_backwards) of_points = sweep_points(is_backwards);
    solver.of_manifolds_ = manifolds.sweep(is_backwards);
    solver.tell_points(changes);
    if (!is_backwards) of_points = sweep_points(is_backwards);
    return std::max(solver.of_manifolds_, of_points);
  }
  double sweep_points(bool is_backwards) {
    const double changed = points.sweep(is_backwards);
    solver.tell_manifolds(changes);
    return changed;
  }
  double squared_change() const { return manifolds.squared_change() + points.squared_change(); }
  void accelerate(const ConjugateDirection& direction) {
    manifolds.accelerate(direction);
    solver.tell_points(changes);
    points.accelerate(direction);
    solver.tell_manifolds(changes);
  }

  MixedSolver& solver;
  VelocityChange<D>& changes;
  ManifoldRows<D> manifolds;
  PointRows<D> points;
};

template <int D>
void MixedSolver<D>::tell_points(VelocityChange<D>& changes) const {
  for (std::size_t k = 0; k < shared_.size(); ++k)
    changes.set_motion(shared_[k], groups_.motion(shared_[k]) - before_[k]);
}

template <int D>
void MixedSolver<D>::tell_manifolds(const VelocityChange<D>& changes) {
  for (std::size_t k = 0; k < shared_.size(); ++k) {
    BlockMotion<D> motion = before_[k];
    motion += changes.of_motion(shared_[k]);
    groups_.set_motion(shared_[k], motion);
  }
}

template <int D>
ImpulseResult MixedSolver<D>::solve(ImpulseProblem<D>& problem, std::span<ContactConstraint<D>> points,
                                    VelocityChange<D>& changes, const ImpulseSettings& settings,
                                    int max_sweeps) {
  find_shared(problem, points);
  groups_.take(problem);
  MixedRows rows{*this, changes, {groups_, groups_.all()}, {points, changes}};
  ImpulseResult result = balance(rows, rows.begin(), max_sweeps, true);
  result.has_converged = result.unbalanced <= settings.tolerance_for(result.fastest);
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
