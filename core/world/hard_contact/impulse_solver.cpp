#include "world/hard_contact/impulse_solver.h"

#include <algorithm>

#include "world/hard_contact/stall.h"

namespace halfspace {
namespace {

/// Sweeps before active sets are tried, doubled each time that they fail.
constexpr int first_sweeps = 4;

/// Where active sets are tried: the cap of the settings never lets a structure fall.
constexpr int max_sweeps = 200;

/// A lower cap does not pause active sets that help: so few sweeps between them would not hold a structure.
constexpr int few_sweeps = 20;

/// Active sets do not settle while sweeps change velocities by more than this fraction of what gravity does.
constexpr double quiet_fraction = 0.5;

/// They help when they leave this fraction of it, and are soon tried again when it is this fraction of what
/// was.
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

/// Active sets that leave much unbalanced are dropped. The next sweeps would not mend them.
template <int D>
bool ImpulseSolver<D>::solve_active_sets(ImpulseProblem<D>& problem, double tolerance, double helpful,
                                         double& unbalanced, bool is_cold) {
  groups_.give(problem);
  const double left = active_set_.solve(problem, tolerance, is_cold);
  if (!(left <= std::max(helpful, tolerance))) return false;
  groups_.renew(problem);
  restart_acceleration();
  unbalanced = left;
  return true;
}

template <int D>
ImpulseResult ImpulseSolver<D>::solve(ImpulseProblem<D>& problem, const ImpulseSettings& settings) {
  const bool is_in_motion = pause_.length > 0, uses_active_sets = pause_.ends_now();
  groups_.take(problem);
  double fastest = groups_.begin();
  conjugate_ = {};
  ImpulseResult result;
  if (fastest == 0 && uses_active_sets)
    solve_active_sets(problem, settings.tolerance * settings.speed, HUGE_VAL, result.unbalanced, true);
  Stall stall;
  int wait = first_sweeps, next_active_set = wait;
  bool have_sets_helped = false;
  bool is_symmetric = false;  // since the last acceleration: as many sweeps forwards as backwards
  for (int i = 1; i <= std::max(max_sweeps, settings.max_iterations); ++i) {
    const bool is_backwards = i % 2 == 0;
    if (is_symmetric) accelerate();
    is_symmetric = is_backwards;
    result.iterations = i;
    result.unbalanced = groups_.sweep(is_backwards);
    fastest = std::max(fastest, result.unbalanced);
    const double tolerance = settings.tolerance_for(fastest);
    result.has_converged = result.unbalanced <= tolerance;
    if (result.has_converged) break;
    const bool is_quiet = result.unbalanced <= quiet_fraction * settings.scale(fastest);
    const bool may_try_sets = uses_active_sets && is_quiet;
    if (is_in_motion && !may_try_sets && i >= settings.sweeps_in_motion(is_quiet)) break;
    if (may_try_sets && i >= next_active_set) {
      const double before = result.unbalanced, helpful = helpful_fraction * settings.scale(fastest);
      if (solve_active_sets(problem, tolerance, helpful, result.unbalanced, false)) {
        have_sets_helped = true;
        is_symmetric = false;
        if (result.unbalanced <= tolerance) {
          pause_ = {};
          return {i, result.unbalanced, true};
        }
      }
      wait = result.unbalanced < helpful_fraction * before ? first_sweeps : 2 * wait;
      next_active_set = i + wait;
    }
    if (stall.is_reached(result.unbalanced)) break;
  }
  groups_.give(problem);
  const bool may_pause = is_in_motion || !have_sets_helped || settings.max_iterations >= few_sweeps;
  if (!result.has_converged && uses_active_sets && may_pause) pause_.begin_longer();
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
