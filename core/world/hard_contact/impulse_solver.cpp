#include "world/hard_contact/impulse_solver.h"

#include <algorithm>
#include <cmath>

#include "world/hard_contact/stall.h"

namespace halfspace {
namespace {

/// Sweeps before active sets are tried, doubled each time that they fail.
constexpr int first_sweeps = 4;

/// Active sets help when they leave this fraction of the velocity unbalanced.
constexpr double helpful_fraction = 0.1;

/// Changes impulses one after the other, and remembers the largest change as a velocity.
template <int D>
class Sweep {
 public:
  explicit Sweep(ImpulseProblem<D>& problem) : problem_(problem) {}

  double largest_change() const { return largest_change_; }

  void visit(const ImpulseContact<D>& contact) {
    for (ImpulseRow<D>& row : problem_.normals_of(contact))
      change(contact, row, std::max(0.0, problem_.stopping_impulse(contact, row)));
    if (contact.friction_count > 0) stop_sliding(contact);
  }

 private:
  void stop_sliding(const ImpulseContact<D>& contact) {
    const std::span<ImpulseRow<D>> friction = problem_.frictions_of(contact);
    std::array<double, max_friction_rows<D>> next;
    problem_.project_friction(contact, problem_.friction_bound(contact), next);
    for (std::size_t k = 0; k < friction.size(); ++k) change(contact, friction[k], next[k]);
  }

  void change(const ImpulseContact<D>& contact, ImpulseRow<D>& row, double impulse) {
    const double change = impulse - row.impulse;
    problem_.set_impulse(contact, row, impulse);
    largest_change_ = std::max(largest_change_, std::abs(change) * row.inverse_mass);
  }

  ImpulseProblem<D>& problem_;
  double largest_change_ = 0;
};

}  // namespace

/// Returns the largest change as a velocity.
template <int D>
double ImpulseSolver<D>::sweep(ImpulseProblem<D>& problem, bool is_backwards) {
  Sweep<D> sweep(problem);
  if (is_backwards) {
    std::for_each(problem.contacts.rbegin(), problem.contacts.rend(),
                  [&](auto& contact) { sweep.visit(contact); });
  } else {
    std::for_each(problem.contacts.begin(), problem.contacts.end(),
                  [&](auto& contact) { sweep.visit(contact); });
  }
  return sweep.largest_change();
}

template <int D>
void ImpulseSolver<D>::restart_acceleration(const ImpulseProblem<D>& problem) {
  conjugate_ = {};
  previous_.resize(problem.rows.size());
  for (std::size_t i = 0; i < problem.rows.size(); ++i) previous_[i] = problem.rows[i].impulse;
  direction_.assign(problem.rows.size(), 0);
}

template <int D>
double ImpulseSolver<D>::squared_change(const ImpulseProblem<D>& problem) const {
  double length = 0;
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    const double change = problem.rows[i].impulse - previous_[i];
    length += change * change * problem.rows[i].inverse_mass;
  }
  return length;
}

template <int D>
void ImpulseSolver<D>::accelerate(ImpulseProblem<D>& problem, const ConjugateDirection& direction) {
  for (const ImpulseContact<D>& contact : problem.contacts) {
    const std::int32_t end = contact.first_row + contact.normal_count + contact.friction_count;
    for (std::size_t i = std::size_t(contact.first_row); i < std::size_t(end); ++i) {
      ImpulseRow<D>& row = problem.rows[i];
      problem.apply(contact, row, direction.advance(row.impulse, previous_[i], direction_[i]));
    }
  }
}

template <int D>
void ImpulseSolver<D>::accelerate(ImpulseProblem<D>& problem) {
  conjugate_.update(squared_change(problem));
  accelerate(problem, conjugate_);
}

template <int D>
double ImpulseSolver<D>::begin(ImpulseProblem<D>& problem) {
  double fastest = 0;
  for (const ImpulseContact<D>& contact : problem.contacts) {
    for (const ImpulseRow<D>& row : problem.normals_of(contact)) {
      problem.apply(contact, row, row.impulse);
      fastest = std::max(fastest, row.impulse * row.inverse_mass);
    }
    for (const ImpulseRow<D>& row : problem.frictions_of(contact)) problem.apply(contact, row, row.impulse);
  }
  restart_acceleration(problem);
  return fastest;
}

template <int D>
void ImpulseSolver<D>::reserve(std::size_t rows, std::size_t blocks) {
  active_set_.reserve(rows, blocks);
  previous_.reserve(rows);
  direction_.reserve(rows);
}

template <int D>
ImpulseResult ImpulseSolver<D>::solve(ImpulseProblem<D>& problem, const ImpulseSettings& settings) {
  double fastest = begin(problem);
  const bool uses_active_sets = pause_.ends_now();
  if (fastest == 0 && uses_active_sets) {
    active_set_.solve(problem, settings.tolerance * settings.speed, true);
    restart_acceleration(problem);
  }
  ImpulseResult result;
  Stall stall;
  int wait = first_sweeps, next_active_set = wait;
  bool is_symmetric = false;  // since the last acceleration: as many sweeps forwards as backwards
  for (int i = 1; i <= settings.max_iterations; ++i) {
    const bool is_backwards = i % 2 == 0;
    if (is_symmetric) accelerate(problem);
    is_symmetric = is_backwards;
    result.iterations = i;
    result.unbalanced = sweep(problem, is_backwards);
    fastest = std::max(fastest, result.unbalanced);
    const double tolerance = settings.tolerance_for(fastest);
    if (result.unbalanced <= tolerance) return result;
    if (i >= next_active_set && uses_active_sets) {
      const double unbalanced = active_set_.solve(problem, tolerance, false);
      if (unbalanced <= tolerance) {
        pause_ = {};
        return {i, unbalanced, true};
      }
      wait = unbalanced < helpful_fraction * result.unbalanced ? first_sweeps : 2 * wait;
      result.unbalanced = std::min(result.unbalanced, unbalanced);
      next_active_set = i + wait;
      restart_acceleration(problem);
      is_symmetric = false;
    }
    if (stall.is_reached(result.unbalanced)) break;
  }
  if (uses_active_sets && next_active_set > first_sweeps) pause_.begin_longer();
  result.has_converged = false;
  return result;
}

template <int D>
void ImpulseSolver<D>::sweep_only(ImpulseProblem<D>& problem, int count) {
  restart_acceleration(problem);
  for (int i = 1; i <= count; ++i) {
    sweep(problem, i % 2 == 0);
    if (i % 2 == 0 && i < count) accelerate(problem);
  }
}

template class ImpulseSolver<2>;
template class ImpulseSolver<3>;

}  // namespace halfspace
