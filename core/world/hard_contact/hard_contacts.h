#pragma once

#include "world/hard_contact/mixed_solver.h"
#include "world/hard_contact/point_contacts.h"
#include "world/hard_contact/rigid_contacts.h"

namespace halfspace {

/// The contacts of laws without springs, and their impulses: manifolds of rigid blocks, and points where a
/// block deforms, is held or may be bonded. In a world without such laws its stages do nothing.
template <int D>
class HardContacts {
 public:
  HardContacts(const Model<D>& model, ContactList<D>& contacts, Integrator<D>& integrator, Memory* memory)
      : model_(model),
        contacts_(contacts),
        integrator_(integrator),
        points_(model, contacts, integrator, memory),
        rigid_(model, contacts, integrator, memory),
        together_(model.blocks, memory),
        loads_(memory) {}

  /// Does any law have no springs?
  bool is_used() const { return model_.materials.laws().knows_no_spring(); }
  const Array<PointContact<D>>& points() const { return points_.all(); }
  const RigidContacts<D>& rigid() const { return rigid_; }
  std::size_t count() const { return points_.all().size() + rigid_.all().size(); }
  std::int64_t touches() const { return points_.touches() + rigid_.touches(); }
  std::int64_t iterations() const { return points_.iterations() + rigid_.iterations(); }
  /// The largest penetration so far where the solver did not converge, over the thickness of the thinner
  /// block.
  double deepest() const { return std::max(points_.deepest(), rigid_.deepest()); }

  /// The largest velocity that the impulses of rigid blocks left unbalanced in the last motion.
  double unbalanced_velocity() const { return rigid_.unbalanced_velocity(); }
  /// The part of the predicted motion before the first impact that is to be located, or 1.
  double fraction_before_impact() const {
    return model_.settings.locate_impacts ? rigid_.fraction_before_impact() : 1;
  }

  using BlockLoad = typename Integrator<D>::BlockLoad;
  /// The sum of the contacts' loads on a block at the end of the last motion; of a compound, those on its
  /// parts. They are summed when they are first asked for after a motion, so that steps do not pay for it.
  BlockLoad load_on(std::size_t slot) const;
  /// Contacts or poses have changed.
  void forget_loads() { are_loads_summed_ = false; }
  /// The world has been edited.
  void forget_rest() { rigid_.forget_rest(); }

  /// The contact with the largest force of the coming motion, or of the last one where none is predicted.
  PressedPair deepest_pressed() const {
    PressedPair pair;
    points_.note_pressed(pair);
    rigid_.note_pressed(pair);
    return pair;
  }
  /// Why the coming motion cannot be made, where a prescribed block jams others.
  const std::optional<Jam>& jam() const { return rigid_.jam(); }

  /// After the neighbour list has been renewed.
  void fit_room() {
    if (!is_used()) return;
    points_.rebuild_surface();
    loads_.reserve(model_.blocks.slot_count());
  }

  /// Calls `visit(a, b)` for a moving and a sleeping block that will touch.
  template <class Visit>
  void for_each_meeting(double duration, Visit visit) {
    if (is_used()) rigid_.for_each_meeting(duration, visit);
  }

  // The stages of a motion, in their order.
  /// Sets all impulses of the coming motion to none.
  void begin(double duration);
  /// Changes a motion predicted without impulses so that no block passes into another. False when the motion
  /// diverges.
  bool predict(double time, double duration);
  /// Adds the work of the impulses of the first half step to the ledger.
  void apply_position_impulses(EnergyLedger& ledger);
  /// Updates the contacts at the end of the motion, before its second half step: none has an impulse yet.
  void find_at_end();
  /// Stops approach at all contacts after the second half step, and adds the work to the ledger.
  void stop_approach(EnergySample& sample, EnergyLedger& ledger);

  /// Another block may reuse the slot.
  void forget(std::int32_t slot) {
    points_.forget();
    rigid_.forget(slot);
  }

  /// The predicted motion is not made.
  void drop_motion() {
    points_.drop_motion();
    rigid_.drop_motion();
  }

  /// False for what cannot be, after reading a snapshot.
  bool is_consistent() const {
    return points_.is_consistent() && rigid_.is_consistent() && pause_.is_consistent();
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(points_, rigid_, pause_);
  }

 private:
  VelocityChange<D>& changes() { return integrator_.kicks(); }
  bool find_impulses(double time, double duration);
  bool set_gap_targets(double time, double duration, bool is_first_search);
  bool close_gaps(double duration);
  bool solve(Half half, double duration);
  bool solve_together(Half half, double duration);
  void sum_loads() const;
  void add_load(std::int32_t a, std::int32_t b, const ContactForce<D>& on_b) const;

  const Model<D>& model_;
  ContactList<D>& contacts_;
  Integrator<D>& integrator_;
  PointContacts<D> points_;
  RigidContacts<D> rigid_;
  MixedSolver<D> together_;
  bool has_points_ = false;
  bool has_converged_ = true;  // in the last solve
  bool has_impact_ = false;    // of manifolds, in this motion
  bool rests_ = false;         // this motion repeats the last one
  SolverPause pause_;          // of active sets beside points, after the last motion
  SolverPause next_pause_;
  mutable Array<BlockLoad> loads_;  // per slot up to the last one with a contact
  mutable bool are_loads_summed_ = false;
};

extern template class HardContacts<2>;
extern template class HardContacts<3>;

}  // namespace halfspace
