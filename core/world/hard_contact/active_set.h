#pragma once

#include <Eigen/SparseCholesky>
#include <cstdint>
#include <span>
#include <vector>

#include "world/hard_contact/impulse_problem.h"

namespace halfspace {

/// Solves an impulse problem by a primal-dual active set method (Hueber and Wohlmuth 2005). Rows whose
/// impulse would be positive after one projection bear, friction within its bound sticks, and beyond it
/// slides. The rows that bear or stick are equations J v = target; their solution gives the next active set.
///
/// The equations are solved by the method of multipliers: each row gets a small compliance e, so that the
/// changes of velocity have the positive definite matrix M + J^T J / e, which is factorized as L D L^T with
/// the blocks in minimum-degree order. Repeated solves remove the effect of the compliance. So redundant
/// contacts, of which walls have twice as many as degrees of freedom, need no special care.
template <int D>
class ActiveSet {
 public:
  explicit ActiveSet(Memory* memory)
      : states_(memory),
        rows_(memory),
        index_of_block_(memory),
        blocks_(memory),
        changes_of_rows_(memory),
        unordered_(memory),
        best_(memory),
        best_motions_(memory) {}

  /// Takes the memory of problems of so many rows and blocks, but for that of the factors.
  void reserve(std::size_t rows, std::size_t blocks);
  /// Changes impulses and motions of an island to those of the active set that leaves the least velocity
  /// unbalanced, which is returned. Ends well within the tolerance, m/s, or when the sets do not settle.
  double solve(ImpulseProblem<D>& problem, std::size_t island, double tolerance, bool is_cold);

 private:
  enum class State : std::uint8_t { open, bears, sticks, slides };
  struct Row {
    std::int32_t row;
    std::int32_t contact;
  };
  double classify(ImpulseProblem<D>& problem, double noise);
  void set_state(std::size_t row, State state);
  void find_blocks(const ImpulseProblem<D>& problem, std::size_t island);
  void order_blocks(const ImpulseProblem<D>& problem);
  void add_block(std::int32_t block);
  bool factorize(const ImpulseProblem<D>& problem);
  bool improve(ImpulseProblem<D>& problem, double tolerance);
  void project(ImpulseProblem<D>& problem) const;
  double refine(ImpulseProblem<D>& problem);
  void keep(const ImpulseProblem<D>& problem);
  void restore(ImpulseProblem<D>& problem) const;

  using Matrix = Eigen::SparseMatrix<double>;

  std::span<const std::int32_t> contacts_;  // of the island
  Array<State> states_;                     // of each row
  int changed_ = 0;                         // states
  double compliance_ = 0;                   // over the inverse effective mass of a row
  Array<Row> rows_;                         // that bear or stick
  Array<std::int32_t> index_of_block_;      // of each slot: its place in blocks_, or -1
  Array<std::int32_t> blocks_;              // that move freely and have a row, in order of elimination
  std::vector<Eigen::Triplet<double>> entries_;
  Matrix matrix_;
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factors_;
  Eigen::VectorXd change_;  // of the unknowns
  Array<double> changes_of_rows_;
  Array<std::int32_t> unordered_;
  Array<double> best_;                  // impulses of each row
  Array<BlockMotion<D>> best_motions_;  // of each slot; only those in blocks_ are kept
};

extern template class ActiveSet<2>;
extern template class ActiveSet<3>;

}  // namespace halfspace
