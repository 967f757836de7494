#pragma once

#include "threads/threads.h"
#include "world/contacts/contact_list.h"
#include "world/contacts/entrance.h"
#include "world/contacts/force_pass.h"
#include "world/hard_contact/hard_contacts.h"
#include "world/ledger.h"
#include "world/model/model.h"
#include "world/motion/continuous_collision.h"
#include "world/motion/penetration_bound.h"
#include "world/motion/sleep.h"
#include "world/share/share.h"

namespace halfspace {

/// Finds the contacts of a world, computes their forces, adds them to the blocks, and books their energies.
/// Pairs that sleep keep the forces they had. In a share, pairs of copies are found, but do not count.
template <int D>
class ContactStage {
 public:
  ContactStage(const Model<D>& model, ContactList<D>& contacts, ForcePass<D>& forces,
               HardContacts<D>& hard_contacts, PenetrationBound<D>& penetration_bound,
               ContinuousCollision<D>& continuous_collision, const Sleep<D>& sleep, Share& share,
               EnergyLedger& ledger, Threads* threads, Memory* memory);

  /// Reserves memory for the neighbour list in use.
  void fit_room();
  /// Finds the contacts at the present positions, unless they are known.
  void find();
  /// Finds the contacts and computes their forces. `elapsed`: time over which shear springs grow, s;
  /// `made`: duration of the motion that has led here, s, or 0.
  void load(double elapsed, double made);
  /// Adds their forces to the blocks and their energies to the ledger.
  void gather();
  /// Contacts and their forces are those of other positions.
  void forget();
  /// Pairs that slept are computed again.
  void forget_sleeping() { are_sleeping_loaded_ = false; }

 private:
  using Evaluation = typename ForcePass<D>::Evaluation;

  template <class OnContact>
  void find_in(const Chunk& chunk, double made, PairSums& sums, OnContact on_contact);
  template <class Visit>
  void pass_over_pairs(Visit visit);
  void find_entrances(double made);
  template <class OnContact>
  void take_in_met(double made, OnContact on_contact);
  void end_finding();
  bool load_pair(std::size_t k, const Contact<D>& contact, Evaluation& evaluation);
  void load_found(const Chunk& chunk, double made, bool are_found, PairSums& sums, Evaluation evaluation);
  void load_sleeping();

  const Model<D>& model_;
  ContactList<D>& contacts_;
  ForcePass<D>& forces_;
  HardContacts<D>& hard_contacts_;
  PenetrationBound<D>& penetration_bound_;
  ContinuousCollision<D>& continuous_collision_;
  const Sleep<D>& sleep_;
  Share& share_;
  EnergyLedger& ledger_;
  Threads* threads_;
  Entrances<D> entrances_;
  Array<PairSums> sums_;              // per chunk of pairs
  double strain_of_sleeping_ = 0;     // J
  bool are_sleeping_loaded_ = false;  // their forces are computed
};

extern template class ContactStage<2>;
extern template class ContactStage<3>;

}  // namespace halfspace
