#include "world/hard_contact/impulse_solver.h"

#include <algorithm>

#include "world/hard_contact/stall.h"

namespace halfspace {
namespace {

/// Sweeps before active sets are tried, doubled each time that they fail.
constexpr int first_sweeps = 4;

/// Active sets help when they leave this fraction of the velocity unbalanced.
constexpr double helpful_fraction = 0.1;

}  // namespace

template <int D>
void ImpulseSolver<D>::reserve(const ImpulseProblem<D>& problem) {
  const std::size_t rows = most_rows(problem), blocks = problem.motions.size();
  active_set_.reserve(rows, blocks);
  groups_.arrange(problem);
  start_.reserve(rows);
  start_motions_.reserve(blocks);
}

template <int D>
bool ImpulseSolver<D>::is_solved(ImpulseProblem<D>& problem, const ImpulseSettings& settings) {
  groups_.take(problem);
  const double fastest = groups_.begin();
  if (!(fastest > 0 && groups_.unbalanced() <= settings.tolerance_for(fastest))) return false;
  groups_.give(problem);
  return true;
}

template <int D>
ImpulseResult ImpulseSolver<D>::solve(ImpulseProblem<D>& problem, const ImpulseSettings& settings) {
  groups_.take(problem);
  double fastest = groups_.begin();
  conjugate_ = {};
  const auto solve_active_set = [&](double tolerance, bool is_cold) {
    groups_.give(problem);
    const double unbalanced = active_set_.solve(problem, tolerance, is_cold);
    groups_.renew(problem);
    restart_acceleration();
    return unbalanced;
  };
  const bool uses_active_sets = pause_.ends_now();
  if (fastest == 0 && uses_active_sets) solve_active_set(settings.tolerance * settings.speed, true);
  ImpulseResult result;
  Stall stall;
  int wait = first_sweeps, next_active_set = wait;
  bool is_symmetric = false;  // since the last acceleration: as many sweeps forwards as backwards
  for (int i = 1; i <= settings.max_iterations; ++i) {
    const bool is_backwards = i % 2 == 0;
    if (is_symmetric) accelerate();
    is_symmetric = is_backwards;
    result.iterations = i;
    result.unbalanced = groups_.sweep(is_backwards);
    fastest = std::max(fastest, result.unbalanced);
    const double tolerance = settings.tolerance_for(fastest);
    result.has_converged = result.unbalanced <= tolerance;
    if (result.has_converged) break;
    if (i >= next_active_set && uses_active_sets) {
      const double unbalanced = solve_active_set(tolerance, false);
      if (unbalanced <= tolerance) {
        pause_ = {};
        return {i, unbalanced, true};
      }
      wait = unbalanced < helpful_fraction * result.unbalanced ? first_sweeps : 2 * wait;
      result.unbalanced = std::min(result.unbalanced, unbalanced);
      next_active_set = i + wait;
      is_symmetric = false;
    }
    if (stall.is_reached(result.unbalanced)) break;
  }
  groups_.give(problem);
  if (!result.has_converged && uses_active_sets && next_active_set > first_sweeps) pause_.begin_longer();
  return result;
}

template <int D>
void ImpulseSolver<D>::sweep_only(ImpulseProblem<D>& problem, int count) {
  groups_.take(problem);
  restart_acceleration();
  for (int i = 1; i <= count; ++i) {
    groups_.sweep(i % 2 == 0);
    if (i % 2 == 0 && i < count) accelerate();
  }
  groups_.give(problem);
}

template class ImpulseSolver<2>;
template class ImpulseSolver<3>;

}  // namespace halfspace
