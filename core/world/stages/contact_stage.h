#pragma once

#include <cstdint>
#include <optional>

#include "world/contacts/entrance.h"
#include "world/stages/state.h"

namespace halfspace {

/// Finds the contacts of a world, computes their forces, adds them to the blocks, and books their energies.
/// Pairs that sleep keep the forces they had. In a share, pairs of copies are found, but do not count.
template <int D>
class ContactStage {
 public:
  explicit ContactStage(State<D>& state)
      : state_(state), entrances_(state.model, state.contacts, state.memory()), sums_(state.memory()) {}

  /// Reserves memory for the neighbour list in use.
  void fit_room();
  /// Finds the contacts at the present positions, unless they are known.
  void find();
  /// Finds the contacts and computes their forces. `elapsed`: time over which shear springs grow, s;
  /// `made`: duration of the motion that has led here, s, or 0.
  void load(double elapsed, double made);
  /// Adds their forces to the blocks and their energies to the ledger.
  void gather();
  /// The list of pairs is new.
  void forget_sleeping() { loaded_sleep_.reset(); }

 private:
  using Evaluation = typename ForcePass<D>::Evaluation;

  bool asks_no_pair() const;
  bool leaves_out(std::size_t k, const Chunk& chunk, PairSums& sums);
  template <bool asks, class OnContact>
  void find_in(const Chunk& chunk, double made, PairSums& sums, OnContact on_contact);
  template <class OnContact>
  void find_in(const Chunk& chunk, double made, PairSums& sums, OnContact on_contact);
  template <class Visit>
  void pass_over_pairs(Visit visit);
  void find_entrances(double made);
  template <class OnContact>
  void take_in_met(double made, OnContact on_contact);
  void end_finding();
  void load_pair(std::size_t k, const Contact<D>& contact, Evaluation& evaluation);
  void load_found(const Chunk& chunk, double made, bool are_found, PairSums& sums, Evaluation evaluation);
  void load_sleeping();

  State<D>& state_;
  Entrances<D> entrances_;
  Array<PairSums> sums_;                       // per chunk of pairs
  double strain_of_sleeping_ = 0;              // J
  std::optional<std::uint32_t> loaded_sleep_;  // Sleep::changes() when forces of sleeping pairs were computed
};

extern template class ContactStage<2>;
extern template class ContactStage<3>;

}  // namespace halfspace
