#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/tolerances.h"
#include "world/hard_contact/accelerated_sweeps.h"
#include "world/hard_contact/active_set.h"
#include "world/hard_contact/contact_groups.h"
#include "world/hard_contact/impulse_problem.h"

namespace halfspace {

struct ImpulseSettings {
  double tolerance = 1e-6;          // velocity that may remain unbalanced, over `speed`
  double tolerance_of_rest = 1e-6;  // the same where all blocks are slow
  double speed = 0;                 // m/s, of gravity over the step
  int max_iterations = 200;

  ImpulseSettings of_rest() const { return {tolerance_of_rest, tolerance_of_rest, speed, max_iterations}; }

  /// The velocity that others are compared with: of gravity or else the largest one by an impulse.
  double scale(double fastest) const { return speed > 0 ? speed : fastest; }
  /// The velocity that may remain: at least the rounding of the largest one.
  double tolerance_for(double fastest) const {
    return std::max(tolerance * scale(fastest), velocity_rounding * fastest);
  }
  /// Sweeps where active sets do not settle, since blocks move past each other. While gravity makes as much
  /// anew in each step, the next ones find what these leave: in a heap that is less by the cube of the
  /// sweeps.
  int sweeps_in_motion() const {
    constexpr double least = 4;
    if (speed == 0) return max_iterations;
    return int(std::min(double(max_iterations), std::max(least, std::round(2 / std::cbrt(tolerance)))));
  }
};

/// Active sets do not settle where many blocks move past each other. They are then tried in one solve of an
/// island out of 2, 4, up to 64.
struct SolverPause {
  static constexpr std::int32_t max_length = 63;

  bool is_consistent() const { return length >= 0 && length <= max_length && left >= 0 && left <= length; }
  template <class Archive>
  void visit(Archive& archive) {
    archive(length, left);
  }
  /// Counts a solve. True if it may use active sets.
  bool ends_now() {
    if (left == 0) return true;
    --left;
    return false;
  }
  void begin_longer() { left = length = std::min(2 * length + 1, max_length); }

  std::int32_t length = 0;  // solves without active sets after the last in which they failed
  std::int32_t left = 0;    // of these still to come
};

/// Solves impulse problems, island by island, from a warm start by accelerated sweeps, and by active sets,
/// which solve stacks and walls exactly in a few factorizations.
template <int D>
class ImpulseSolver {
 public:
  explicit ImpulseSolver(Memory* memory)
      : active_set_(memory), groups_(memory), pauses_(memory), start_(memory), start_motions_(memory) {}

  /// Takes the memory of problems of these contacts, with these rows or other friction rows.
  void reserve(const ImpulseProblem<D>& problem);
  /// Do the impulses of the problem solve it within the tolerance? Then they are added to its motions.
  bool is_solved(ImpulseProblem<D>& problem, const ImpulseSettings& settings);
  /// The problem's motions contain the velocities without impulses.
  ImpulseResult solve(ImpulseProblem<D>& problem, const ImpulseSettings& settings);

  /// The pause of each block's island.
  const Array<SolverPause>& pauses() const { return pauses_; }
  void set_pauses(const Array<SolverPause>& pauses) { pauses_.assign(pauses.begin(), pauses.end()); }
  /// So many sweeps only; the problem's motions contain its impulses.
  void sweep_only(ImpulseProblem<D>& problem, int count);
  /// Asks after so many sweeps more, and returns to the impulses before them.
  template <class Ask>
  auto ask_after_sweeps(ImpulseProblem<D>& problem, int count, Ask ask) {
    start_.clear();
    for (const ImpulseRow<D>& row : problem.rows) start_.push_back(row.impulse);
    start_motions_.assign(problem.motions.begin(), problem.motions.end());
    sweep_only(problem, count);
    const auto answer = ask();
    for (std::size_t i = 0; i < start_.size(); ++i) problem.rows[i].impulse = start_[i];
    std::copy(start_motions_.begin(), start_motions_.end(), problem.motions.begin());
    return answer;
  }

 private:
  using Part = typename ContactGroups<D>::Part;
  /// True if they help; then they replace the impulses.
  bool solve_active_sets(ImpulseProblem<D>& problem, std::size_t island, double tolerance, double helpful,
                         double& unbalanced, bool is_cold);
  ImpulseResult solve_island(ImpulseProblem<D>& problem, std::size_t island,
                             const ImpulseSettings& of_motion);
  void sweep_normals(const Part& part);
  SolverPause pause_of(const ImpulseProblem<D>& problem, std::size_t island) const;
  void set_pause(const ImpulseProblem<D>& problem, std::size_t island, const SolverPause& pause);

  ActiveSet<D> active_set_;
  ContactGroups<D> groups_;
  Array<SolverPause> pauses_;  // of each block
  Array<double> start_;        // of ask_after_sweeps()
  Array<BlockMotion<D>> start_motions_;
};

extern template class ImpulseSolver<2>;
extern template class ImpulseSolver<3>;

}  // namespace halfspace
