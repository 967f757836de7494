#pragma once

#include <cstdint>
#include <optional>

#include "world/contacts/entrance.h"
#include "world/stages/pairs_by_law.h"
#include "world/stages/state.h"

namespace halfspace {

/// Finds the contacts of a world, computes their forces, adds them to the blocks, and books their energies.
/// Pairs that sleep keep the forces they had. In a share, pairs of copies are found, but do not count.
template <int D>
class ContactStage {
 public:
  explicit ContactStage(State<D>& state)
      : state_(state),
        pairs_(state.memory()),
        entrances_(state.model, state.contacts, state.memory()),
        sums_(state.memory()) {}

  /// Reserves memory for a list of pairs that is new, or about to be.
  void fit_room();
  /// Finds the contacts at the present positions, unless they are known.
  void find();
  /// Finds the contacts and computes their forces. `elapsed`: time over which shear springs grow, s;
  /// `made`: duration of the motion that has led here, s, or 0.
  void load(double elapsed, double made);
  /// Adds their forces to the blocks and their energies to the ledger.
  void gather();

 private:
  using Evaluation = typename ForcePass<D>::Evaluation;

  void sort_pairs();
  template <class Visit>
  void pass_over_pairs(Visit visit);
  /// Calls `visit(kind)` with the kind of a pair's law.
  template <class Visit>
  void for_kind_of(const Candidate<D>& pair, Visit visit) const {
    for_spring_kind(state_.model.law_of(pair).stiffness_kind, visit);
  }
  template <class OnContact>
  void find_in(const Chunk& chunk, double made, PairSums& sums, OnContact on_contact);
  template <StiffnessKind kind>
  void note_found(const Candidate<D>& pair, const Contact<D>& contact, Found found, PairSums& sums) const;
  void find_entrances(double made);
  template <class OnContact>
  void take_in_met(double made, OnContact on_contact);
  void end_finding();
  template <StiffnessKind kind>
  void load_pair(std::size_t k, const Contact<D>& contact, Evaluation& evaluation);
  void load_known(std::size_t k, Evaluation& evaluation);
  void load_sleepers();

  State<D>& state_;
  PairsByLaw<D> pairs_;
  std::optional<std::uint32_t> sorted_for_;  // Sleep::changes() when they were sorted
  Entrances<D> entrances_;
  Array<PairSums> sums_;  // per chunk of pairs
  bool are_sleepers_loaded_ = false;
  double strain_of_sleepers_ = 0;  // J
};

extern template class ContactStage<2>;
extern template class ContactStage<3>;

}  // namespace halfspace
