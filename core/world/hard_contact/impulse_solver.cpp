#include "world/hard_contact/impulse_solver.h"

#include <algorithm>

#include "geometry/tolerances.h"

namespace halfspace {
namespace {

/// Sweeps before active sets are tried, doubled each time that they fail.
constexpr int first_sweeps = 4;

/// Where active sets are tried: the cap of the settings never lets a structure fall.
constexpr int max_sweeps = 200;

/// A lower cap does not pause active sets that help: so few sweeps between them would not hold a structure.
constexpr int few_sweeps = 20;

/// Sweeps of normal impulses alone, where friction has kept all from a solution.
constexpr int normal_sweeps = 40;

}  // namespace

template <int D>
void ImpulseSolver<D>::reserve(const ImpulseProblem<D>& problem) {
  const std::size_t rows = max_rows(problem), blocks = problem.motions.size();
  active_set_.reserve(rows, blocks);
  groups_.arrange(problem);
  pauses_.resize(blocks);
  start_.reserve(rows);
  start_motions_.reserve(blocks);
}

template <int D>
bool ImpulseSolver<D>::is_solved(ImpulseProblem<D>& problem, const ImpulseSettings& settings) {
  groups_.take(problem);
  const Part all = groups_.all();
  const double fastest = groups_.begin(all);
  if (!(fastest > 0 && groups_.unbalanced(all) <= settings.of_rest().tolerance_for(fastest))) return false;
  groups_.give(all, problem);
  return true;
}

/// Active sets that leave much unbalanced are dropped. The next sweeps would not mend them.
template <int D>
bool ImpulseSolver<D>::solve_active_sets(ImpulseProblem<D>& problem, std::size_t island, double tolerance,
                                         double helpful, double& unbalanced, bool is_cold) {
  groups_.give(groups_.island(island), problem);
  const double left = active_set_.solve(problem, island, tolerance, is_cold);
  if (!(left <= std::max(helpful, tolerance))) return false;
  groups_.renew(groups_.island(island), problem);
  unbalanced = left;
  return true;
}

template <int D>
ImpulseResult ImpulseSolver<D>::solve(ImpulseProblem<D>& problem, const ImpulseSettings& settings) {
  groups_.take(problem);
  ImpulseResult all;
  for (std::size_t island = 0; island < problem.islands.count(); ++island)
    all.add(solve_island(problem, island, settings));
  groups_.give(groups_.all(), problem);
  return all;
}

/// Where all blocks are slow they may stand: a large tolerance would hold those that ought to slide. Where
/// most of them move past each other, sets that have failed come after the sweeps and rarely: they cost as
/// much, and are soon those of another place.
template <int D>
ImpulseResult ImpulseSolver<D>::solve_island(ImpulseProblem<D>& problem, std::size_t island,
                                             const ImpulseSettings& of_motion) {
  const ImpulseSettings settings = problem.all_slow(island) ? of_motion.of_rest() : of_motion;
  const Part groups = groups_.island(island);
  SolverPause pause = pause_of(problem, island);
  const bool is_in_motion = pause.length > 0, uses_active_sets = pause.ends_now();
  const bool slips = is_in_motion && problem.max_slip(island, slip_fraction * settings.speed);
  double fastest = groups_.begin(groups);
  ManifoldRows<D> rows{groups_, groups};
  AcceleratedSweeps sweeps(rows);
  ImpulseResult result;
  if (fastest == 0 && uses_active_sets &&
      solve_active_sets(problem, island, settings.tolerance * settings.speed, HUGE_VAL, result.unbalanced,
                        true))
    sweeps.restart();
  Stall stall;
  int wait = slips ? settings.sweeps_in_motion() : first_sweeps, next_active_set = wait;
  bool have_sets_helped = false, has_restarted = false;
  for (int i = 1; i <= std::max(max_sweeps, settings.max_iterations); ++i) {
    result.iterations = i;
    result.unbalanced = sweeps.next();
    fastest = std::max(fastest, result.unbalanced);
    const double tolerance = settings.tolerance_for(fastest);
    result.has_converged = result.unbalanced <= tolerance;
    if (result.has_converged) break;
    const bool is_quiet = result.unbalanced <= quiet_fraction * settings.scale(fastest);
    const bool may_try_sets = uses_active_sets && is_quiet;
    if (is_in_motion && !may_try_sets && i >= settings.sweeps_in_motion()) break;
    if (may_try_sets && i >= next_active_set) {
      const double before = result.unbalanced, helpful = worthwhile * settings.scale(fastest);
      if (solve_active_sets(problem, island, tolerance, helpful, result.unbalanced, false)) {
        have_sets_helped = true;
        sweeps.restart();
        result.has_converged = result.unbalanced <= tolerance;
        if (result.has_converged) break;
      }
      if (slips) break;
      wait = result.unbalanced < worthwhile * before ? first_sweeps : 2 * wait;
      next_active_set = i + wait;
    }
    if (!stall.is_reached(result.unbalanced)) continue;
    if (is_quiet || has_restarted || i + 2 * normal_sweeps > max_sweeps) break;
    sweep_normals(groups);
    sweeps.restart();
    i += normal_sweeps;
    has_restarted = true;
    stall = {};
  }
  const bool are_sets_of_use = have_sets_helped && !slips;
  const bool may_pause = is_in_motion || !are_sets_of_use || settings.max_iterations >= few_sweeps;
  if (are_sets_of_use && result.has_converged)
    pause = {};
  else if (uses_active_sets && (have_sets_helped || !result.has_converged) && may_pause)
    pause.begin_longer();
  set_pause(problem, island, pause);
  return result;
}

/// The bound of friction follows the normal impulses of a sweep: from a start far from the solution, as at
/// the impact of a column, that may come to a cycle. From the solution without friction it does not.
template <int D>
void ImpulseSolver<D>::sweep_normals(const Part& part) {
  ManifoldRows<D> rows{groups_, part, false};
  AcceleratedSweeps sweeps(rows);
  sweeps.restart();
  for (int i = 0; i < normal_sweeps; ++i) sweeps.next();
  sweeps.accelerate();
}

/// The longest pause of the island's blocks, which may have been in different ones: sets fail where they fail
/// for a part.
template <int D>
SolverPause ImpulseSolver<D>::pause_of(const ImpulseProblem<D>& problem, std::size_t island) const {
  SolverPause longest;
  problem.for_each_free_block(island, [&](std::int32_t block) {
    const SolverPause& pause = pauses_[std::size_t(block)];
    if (longest.length < pause.length) longest = pause;
  });
  return longest;
}

template <int D>
void ImpulseSolver<D>::set_pause(const ImpulseProblem<D>& problem, std::size_t island,
                                 const SolverPause& pause) {
  problem.for_each_free_block(island, [&](std::int32_t block) { pauses_[std::size_t(block)] = pause; });
}

template <int D>
void ImpulseSolver<D>::sweep_only(ImpulseProblem<D>& problem, int count) {
  groups_.take(problem);
  ManifoldRows<D> rows{groups_, groups_.all()};
  AcceleratedSweeps sweeps(rows);
  sweeps.restart();
  for (int i = 0; i < count; ++i) sweeps.next();
  groups_.give(groups_.all(), problem);
}

template class ImpulseSolver<2>;
template class ImpulseSolver<3>;

}  // namespace halfspace
