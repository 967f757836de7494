#include "world/hard_contact/active_set.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "geometry/tolerances.h"

namespace halfspace {
namespace {

/// Compliances over a row's inverse effective mass. Where redundant contacts contradict each other the first
/// keeps their impulses small; tall stacks need the last.
constexpr double first_compliance = 1e-6, last_compliance = 1e-11, compliance_ratio = 1e-3;

constexpr int max_sets = 20;
constexpr int max_refinements = 24;

/// The unknowns of a block: velocity and spin.
template <int D>
constexpr int unknowns = D == 2 ? 3 : 6;

template <int D>
using Unknowns = Eigen::Matrix<double, unknowns<D>, 1>;

/// The velocity along a row is this times the unknowns of b, or less this times those of a.
template <int D>
Unknowns<D> jacobian_of(const ImpulseRow<D>& row, bool of_a) {
  Unknowns<D> jacobian;
  jacobian << row.direction, of_a ? row.turn_a : row.turn_b;
  return jacobian;
}

}  // namespace

template <int D>
void ActiveSet<D>::set_state(std::size_t row, State state) {
  changed_ += states_[row] != state;
  states_[row] = state;
}

/// Finds the state of each row by the impulse that one projection would give it. Returns the largest velocity
/// that it would change.
template <int D>
double ActiveSet<D>::classify(ImpulseProblem<D>& problem, double noise) {
  rows_.clear();
  changed_ = 0;
  double unbalanced = 0;
  for (const std::int32_t c : contacts_) {
    const ImpulseContact<D>& contact = problem.contacts[std::size_t(c)];
    std::int32_t row = contact.first_row;
    bool bears = false;
    for (const ImpulseRow<D>& normal : problem.normals_of(contact)) {
      const double projected = problem.stopping_impulse(contact, normal);
      const bool row_bears = projected * normal.inverse_mass > noise;
      unbalanced =
          std::max(unbalanced, std::abs(std::max(0.0, projected) - normal.impulse) * normal.inverse_mass);
      set_state(std::size_t(row), row_bears ? State::bears : State::open);
      if (row_bears) rows_.push_back({row, c});
      bears = bears || row_bears;
      ++row;
    }
    if (contact.friction_count == 0) continue;
    const std::span<ImpulseRow<D>> friction = problem.frictions_of(contact);
    const double bound = problem.friction_bound(contact);
    std::array<double, max_friction_rows<D>> projected{};
    const double size = problem.project_friction(contact, bound, projected);
    // A contact that has just begun to bear has no bound yet: it sticks at first.
    const bool sticks = bears && (bound <= 0 || size < bound);
    for (std::size_t k = 0; k < friction.size(); ++k) {
      const double change = projected[k] - friction[k].impulse;
      unbalanced = std::max(unbalanced, std::abs(change) * friction[k].inverse_mass);
      set_state(std::size_t(row), sticks ? State::sticks : bears ? State::slides : State::open);
      if (sticks) rows_.push_back({row, c});
      ++row;
    }
  }
  return unbalanced;
}

template <int D>
void ActiveSet<D>::add_block(std::int32_t block) {
  std::int32_t& index = index_of_block_[std::size_t(block)];
  if (index >= 0) return;
  index = std::int32_t(blocks_.size());
  blocks_.push_back(block);
}

template <int D>
void ActiveSet<D>::find_blocks(const ImpulseProblem<D>& problem, std::size_t island) {
  for (const std::int32_t block : blocks_) index_of_block_[std::size_t(block)] = -1;
  index_of_block_.resize(problem.motions.size(), -1);
  blocks_.clear();
  problem.for_each_free_block(island, [&](std::int32_t block) { add_block(block); });
}

template <int D>
void ActiveSet<D>::order_blocks(const ImpulseProblem<D>& problem) {
  const int count = int(blocks_.size());
  entries_.clear();
  for (const std::int32_t c : contacts_) {
    const ImpulseContact<D>& contact = problem.contacts[std::size_t(c)];
    const std::int32_t a = index_of_block_[std::size_t(contact.a)],
                       b = index_of_block_[std::size_t(contact.b)];
    if (a >= 0 && b >= 0) entries_.emplace_back(std::max(a, b), std::min(a, b), 1.0);
  }
  for (int i = 0; i < count; ++i) entries_.emplace_back(i, i, 1.0);
  Matrix neighbors(count, count);
  neighbors.setFromTriplets(entries_.begin(), entries_.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(neighbors.selfadjointView<Eigen::Lower>(), order);
  unordered_.assign(blocks_.begin(), blocks_.end());
  for (int i = 0; i < count; ++i) {
    blocks_[std::size_t(i)] = unordered_[std::size_t(order.indices()[i])];
    index_of_block_[std::size_t(blocks_[std::size_t(i)])] = i;
  }
}

template <int D>
bool ActiveSet<D>::factorize(const ImpulseProblem<D>& problem) {
  using Square = Eigen::Matrix<double, unknowns<D>, unknowns<D>>;
  constexpr int n = unknowns<D>;
  entries_.clear();
  const auto add = [&](std::int32_t i, std::int32_t k, const Square& part) {
    for (int row = 0; row < n; ++row)
      for (int column = 0; column < (i == k ? row + 1 : n); ++column)
        entries_.emplace_back(n * i + row, n * k + column, part(row, column));
  };
  for (std::size_t r = 0; r < rows_.size();) {
    const std::int32_t c = rows_[r].contact;
    const ImpulseContact<D>& contact = problem.contacts[std::size_t(c)];
    const std::int32_t a = index_of_block_[std::size_t(contact.a)],
                       b = index_of_block_[std::size_t(contact.b)];
    Square aa = Square::Zero(), ab = Square::Zero(), bb = Square::Zero();
    for (; r < rows_.size() && rows_[r].contact == c; ++r) {
      const ImpulseRow<D>& row = problem.rows[std::size_t(rows_[r].row)];
      const double stiffness = 1 / (compliance_ * row.inverse_mass);
      const Unknowns<D> of_a = jacobian_of(row, true), of_b = jacobian_of(row, false);
      aa += stiffness * of_a * of_a.transpose();
      ab -= stiffness * of_a * of_b.transpose();
      bb += stiffness * of_b * of_b.transpose();
    }
    if (a >= 0) add(a, a, aa);
    if (b >= 0) add(b, b, bb);
    if (a >= 0 && b >= 0) a > b ? add(a, b, ab) : add(b, a, ab.transpose());
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const InverseMass<D>& inverse = problem.inverse_masses[std::size_t(blocks_[i])];
    Square mass = Square::Zero();
    mass.diagonal().template head<D>().setConstant(1 / inverse.of_mass);
    mass.template bottomRightCorner<n - D, n - D>() = inverse.of_inertia.inverse();
    add(std::int32_t(i), std::int32_t(i), mass);
  }
  const Eigen::Index count = n * Eigen::Index(blocks_.size());
  matrix_.resize(count, count);
  matrix_.setFromTriplets(entries_.begin(), entries_.end());
  factors_.compute(matrix_);
  return factors_.info() == Eigen::Success;
}

/// Open rows have no impulse, and friction that slides is at its bound, against the sliding, unless that is
/// reversed.
template <int D>
void ActiveSet<D>::project(ImpulseProblem<D>& problem) const {
  for (const std::int32_t c : contacts_) {
    const ImpulseContact<D>& contact = problem.contacts[std::size_t(c)];
    std::size_t row = std::size_t(contact.first_row);
    for (ImpulseRow<D>& normal : problem.normals_of(contact)) {
      if (states_[row++] == State::open) problem.set_impulse(contact, normal, 0);
    }
    if (contact.friction_count == 0) continue;
    const std::span<ImpulseRow<D>> friction = problem.frictions_of(contact);
    const double bound = std::max(0.0, problem.friction_bound(contact));
    if (states_[row] == State::sticks) continue;
    std::array<double, max_friction_rows<D>> opposing{};
    const bool is_reversed = problem.project_friction(contact, bound, opposing) == HUGE_VAL;
    double square = 0;
    for (const double part : opposing) square += part * part;
    const double scale = is_reversed ? 1 : square > 0 ? bound / std::sqrt(square) : 0;
    for (std::size_t k = 0; k < friction.size(); ++k)
      problem.set_impulse(contact, friction[k], scale * opposing[k]);
  }
}

/// One solve for the velocities that remain. Returns the largest of them before.
template <int D>
double ActiveSet<D>::refine(ImpulseProblem<D>& problem) {
  project(problem);
  constexpr int n = unknowns<D>;
  change_.setZero(n * Eigen::Index(blocks_.size()));
  double remaining = 0;
  const auto velocity_of = [&](const Row& active) {
    const ImpulseRow<D>& row = problem.rows[std::size_t(active.row)];
    return problem.velocity_along(problem.contacts[std::size_t(active.contact)], row) - row.target;
  };
  for (const Row& active : rows_) {
    const ImpulseContact<D>& contact = problem.contacts[std::size_t(active.contact)];
    const ImpulseRow<D>& row = problem.rows[std::size_t(active.row)];
    const double velocity = velocity_of(active);
    const double force = -velocity / (compliance_ * row.inverse_mass);
    const std::int32_t a = index_of_block_[std::size_t(contact.a)],
                       b = index_of_block_[std::size_t(contact.b)];
    if (a >= 0) change_.template segment<n>(n * a) -= force * jacobian_of(row, true);
    if (b >= 0) change_.template segment<n>(n * b) += force * jacobian_of(row, false);
    remaining = std::max(remaining, std::abs(velocity));
  }
  change_ = factors_.solve(change_);
  changes_of_rows_.resize(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const ImpulseContact<D>& contact = problem.contacts[std::size_t(rows_[i].contact)];
    const ImpulseRow<D>& row = problem.rows[std::size_t(rows_[i].row)];
    const std::int32_t a = index_of_block_[std::size_t(contact.a)],
                       b = index_of_block_[std::size_t(contact.b)];
    double velocity = velocity_of(rows_[i]);
    if (a >= 0) velocity -= jacobian_of(row, true).dot(change_.template segment<n>(n * a));
    if (b >= 0) velocity += jacobian_of(row, false).dot(change_.template segment<n>(n * b));
    changes_of_rows_[i] = -velocity / (compliance_ * row.inverse_mass);
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    ImpulseRow<D>& row = problem.rows[std::size_t(rows_[i].row)];
    problem.apply(problem.contacts[std::size_t(rows_[i].contact)], row, changes_of_rows_[i]);
    row.impulse += changes_of_rows_[i];
  }
  return remaining;
}

template <int D>
void ActiveSet<D>::keep(const ImpulseProblem<D>& problem) {
  best_.clear();
  for (const std::int32_t c : contacts_)
    for (const ImpulseRow<D>& row : problem.rows_of(problem.contacts[std::size_t(c)]))
      best_.push_back(row.impulse);
  best_motions_.resize(problem.motions.size());
  for (const std::int32_t block : blocks_)
    best_motions_[std::size_t(block)] = problem.motions[std::size_t(block)];
}

/// Impulses that pull are within the tolerance, and end as none.
template <int D>
void ActiveSet<D>::restore(ImpulseProblem<D>& problem) const {
  for (const std::int32_t block : blocks_)
    problem.motions[std::size_t(block)] = best_motions_[std::size_t(block)];
  auto best = best_.begin();
  for (const std::int32_t c : contacts_) {
    const ImpulseContact<D>& contact = problem.contacts[std::size_t(c)];
    for (ImpulseRow<D>& row : problem.rows_of(contact)) row.impulse = *best++;
    for (ImpulseRow<D>& row : problem.normals_of(contact))
      problem.set_impulse(contact, row, std::max(0.0, row.impulse));
  }
}

/// Solves for the present active set. False when it cannot be factorized.
template <int D>
bool ActiveSet<D>::improve(ImpulseProblem<D>& problem, double tolerance) {
  if (rows_.empty() || !factorize(problem)) return false;
  double last = HUGE_VAL;
  for (int i = 0; i < max_refinements; ++i) {
    const double remaining = refine(problem);
    if (remaining <= refined_within * tolerance || !(remaining < 0.5 * last)) break;
    last = remaining;
  }
  return true;
}

template <int D>
void ActiveSet<D>::reserve(std::size_t rows, std::size_t blocks) {
  states_.reserve(rows);
  rows_.reserve(rows);
  changes_of_rows_.reserve(rows);
  best_.reserve(rows);
  index_of_block_.reserve(blocks);
  blocks_.reserve(blocks);
  unordered_.reserve(blocks);
  best_motions_.reserve(blocks);
}

template <int D>
double ActiveSet<D>::solve(ImpulseProblem<D>& problem, std::size_t island, double tolerance, bool is_cold) {
  const double noise = refined_within * tolerance;
  contacts_ = problem.islands.contacts_of(island);
  states_.resize(problem.rows.size());
  compliance_ = first_compliance;
  double least = classify(problem, is_cold ? -noise : noise), last = HUGE_VAL;
  find_blocks(problem, island);
  keep(problem);
  try {
    order_blocks(problem);
    for (int i = 0; i < max_sets && least > solved_within * tolerance && improve(problem, tolerance); ++i) {
      const double unbalanced = classify(problem, noise);
      if (unbalanced < least) {
        least = unbalanced;
        keep(problem);
      }
      if (!(unbalanced < diverged_ratio * last)) break;
      const bool stays = changed_ == 0 && unbalanced > worthwhile * last;
      last = std::min(last, unbalanced);
      if (!stays) continue;
      if (compliance_ <= last_compliance) break;
      compliance_ *= compliance_ratio;
    }
  } catch (const std::bad_alloc&) {
    // Eigen takes its memory from the system. Without any, sweeps go on from the best solution.
  }
  restore(problem);
  return least;
}

template class ActiveSet<2>;
template class ActiveSet<3>;

}  // namespace halfspace
