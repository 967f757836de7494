#pragma once

#include "world/hard_contact/active_set.h"
#include "world/hard_contact/impulse_problem.h"

namespace halfspace {

struct ImpulseSettings {
  double tolerance = 1e-6;  // velocity that may remain unbalanced, over `speed`
  double speed = 0;         // m/s, of gravity over the step
  int max_iterations = 100;
};

struct ImpulseResult {
  int iterations = 0;
  double unbalanced = 0;  // m/s, the largest velocity that the last iteration changed
  bool has_converged = true;
};

/// Solves impulse problems from a warm start by sweeps of projected Gauss-Seidel (NLGS, Jean 1999),
/// accelerated by nonsmooth conjugate gradients (Silcowitz-Hansen, Niebe and Erleben 2010), and by active
/// sets, which solve stacks and walls exactly in a few factorizations.
template <int D>
class ImpulseSolver {
 public:
  explicit ImpulseSolver(Memory* memory) : active_set_(memory), previous_(memory), direction_(memory) {}

  /// Takes the memory of problems of so many rows and blocks.
  void reserve(std::size_t rows, std::size_t blocks);
  /// The problem's motions contain the velocities without impulses.
  ImpulseResult solve(ImpulseProblem<D>& problem, const ImpulseSettings& settings);
  bool is_consistent() const {
    return pause_ >= 0 && pause_ <= max_pause && paused_ >= 0 && paused_ <= pause_;
  }
  template <class Archive>
  void visit(Archive& archive) {
    archive(pause_, paused_);
  }
  /// So many sweeps only, from no impulses.
  void sweep_only(ImpulseProblem<D>& problem, int count);

 private:
  /// Solves without active sets after they have failed in as many and one more.
  static constexpr std::int32_t max_pause = 63;

  bool may_use_active_sets();
  double sweep(ImpulseProblem<D>& problem, bool is_backwards);
  void accelerate(ImpulseProblem<D>& problem);
  void restart_acceleration(const ImpulseProblem<D>& problem);

  ActiveSet<D> active_set_;
  Array<double> previous_;   // impulses two sweeps ago
  Array<double> direction_;  // of search
  double last_length_ = 0;
  std::int32_t pause_ = 0;   // solves without active sets after the last that they did not end
  std::int32_t paused_ = 0;  // of these still to come
};

extern template class ImpulseSolver<2>;
extern template class ImpulseSolver<3>;

}  // namespace halfspace
