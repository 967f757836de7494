#pragma once

#include <cstdint>
#include <tuple>

#include "threads/threads.h"
#include "world/contacts/contact_list.h"
#include "world/contacts/force_pass.h"
#include "world/hard_contact/hard_contacts.h"
#include "world/model/model.h"
#include "world/model/share.h"
#include "world/motion/clock.h"
#include "world/motion/continuous_collision.h"
#include "world/motion/integrator.h"
#include "world/motion/ledger.h"
#include "world/motion/penetration_bound.h"
#include "world/motion/sleep.h"
#include "world/motion/stable_step.h"

namespace halfspace {

/// All that a world keeps from step to step: parts, each after those that it reads, and the model, which it
/// refers to. Stages (stages/stages.h) take them from one time to the next. Its functions say once whatever
/// several parts have to be told.
template <int D>
struct State {
  /// The model, and the threads, if any, must outlive the state.
  State(Model<D>& of, Threads* workers);
  State(const State&) = delete;  // they refer to each other

  Memory* memory() const { return model.blocks.kind.get_allocator().resource(); }

  /// Called by every external change: contacts, forces and ledger are brought up to date before the next
  /// motion, and the change of energy counts as external work.
  void edit();
  /// Other blocks may touch, or elsewhere: an edit after which contacts are found again.
  void change_contacts();
  /// Other pairs may touch, or pairs have other laws or bonds: an edit after which the list of pairs is made
  /// anew, as shear springs may be needed.
  void change_pairs();
  /// A motion that has been predicted is not made.
  void drop_motion();
  /// The same in a share, where the world changes between prediction and motion: the next step predicts
  /// another.
  void drop_shared_motion();
  /// Contacts and their forces are those of other positions.
  void forget_contacts();
  /// Another block may reuse the slot.
  void forget_block(std::int32_t slot);
  /// A block was added, alone or as a part of a compound or of a surface.
  void note_added(std::int32_t slot);
  void note_speeds(const EnergySample& sample);
  bool is_edited() const { return edited != 0; }
  /// A block that only rotates fast may have no pair.
  bool names_fast_pair() const {
    const FastPair& pair = continuous_collision.pair();
    return continuous_collision.any() && pair.a != pair.b;
  }

  /// Calls `visit(a, b)` for all blocks in touch or connected by a bolt.
  template <class Visit>
  void for_each_touch(Visit visit) const {
    for (std::size_t c = 0; c < contacts.count(); ++c) visit(contacts.pair_of(c).a, contacts.pair_of(c).b);
    for (const RigidContact<D>& contact : hard_contacts.rigid().all()) visit(contact.a, contact.b);
    for (const Bolt<D>& bolt : model.bolts.all()) {
      if (bolt.a >= 0 && bolt.b >= 0 && !bolt.is_ruptured) visit(bolt.a, bolt.b);
    }
  }
  /// Wakes the islands that a moving block touches.
  void wake_touched(double time) {
    sleep.wake_touched([&](auto visit) { for_each_touch(visit); }, time);
  }
  /// Current maxima, over all contacts and over all free blocks.
  double largest_overlap() const;
  double largest_speed() const;

  /// State that a step after an edit writes before it moves the blocks, except the pairs and derived data. It
  /// is set back when memory runs out.
  auto written_before_motion() {
    return std::tuple_cat(contacts.state(), forces.state(), ledger.state(), clock.epoch(),
                          model.blocks.bonds().state(), model.blocks.meshes().state(), model.bolts.state(),
                          std::tie(bond_strain, bolt_strain, peak_speed, edited));
  }
  /// Validates the state read from a snapshot, so that a damaged one is refused.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(model, contacts, forces, integrator, ledger, clock, penetration_bound, peak_speed, bond_strain,
            bolt_strain, strength_factor, hard_contacts, sleep, edited, share);
  }

  Model<D>& model;
  Threads* threads;
  EnergyLedger ledger;
  Clock clock;
  ContactList<D> contacts;
  ForcePass<D> forces;
  Share share;
  Sleep<D> sleep;
  Integrator<D> integrator;
  HardContacts<D> hard_contacts;
  StableStep<D> stable_step;
  PenetrationBound<D> penetration_bound;
  ContinuousCollision<D> continuous_collision;
  double bond_strain = 0;      // J
  double bolt_strain = 0;      // J
  double peak_speed = 0;       // of the free blocks, at the ends of all motions so far, m/s
  double strength_factor = 1;  // by which all given strengths of laws and bonds are divided
  std::int32_t edited = 1;     // 1: forces, accelerations and ledger are out of date
};

extern template struct State<2>;
extern template struct State<3>;

}  // namespace halfspace
