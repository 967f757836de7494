#pragma once

#include "world/hard_contact/impulse_rows.h"
#include "world/hard_contact/impulse_solver.h"
#include "world/hard_contact/impulse_work.h"
#include "world/hard_contact/jam.h"
#include "world/hard_contact/rest.h"
#include "world/model/model.h"
#include "world/motion/integrator.h"
#include "world/motion/ledger.h"

namespace halfspace {

// Non-smooth contact dynamics of rigid blocks (Moreau 1988, Jean 1999) within velocity Verlet: the impulses
// of the first half step keep every gap open at the motion's end, those of the second stop approach there, or
// reverse it by the coefficient of restitution. Both are one impulse problem each, on the same manifolds.

/// The contacts of rigid blocks by laws without springs, and their impulses.
template <int D>
class RigidContacts {
 public:
  RigidContacts(const Model<D>& model, ContactList<D>& contacts, Integrator<D>& integrator, Memory* memory)
      : model_(model),
        blocks_(model.blocks),
        integrator_(integrator),
        search_(model, contacts, integrator, memory),
        rows_(model, search_),
        solver_(memory),
        problem_(memory),
        rest_(model, integrator, memory),
        known_(memory),
        next_known_(memory),
        predicted_(memory),
        first_(memory),
        free_motions_(memory),
        pauses_(memory),
        work_of_islands_(memory) {}

  /// Those at the end of the last motion, in order of their blocks.
  const Array<RigidContact<D>>& all() const { return known_; }
  std::int64_t touches() const { return touches_; }
  std::int64_t iterations() const { return iterations_; }
  /// The impulses of equal forces in a motion of this duration over those of the last motion.
  double impulse_scale(double duration) const { return duration_ > 0 ? duration / duration_ : 1; }
  /// The largest overlap of the last motion, m; 0 when no contact overlaps.
  double largest_overlap() const;
  /// The largest penetration so far over the thickness of the thinner block.
  double deepest() const { return deepest_; }
  double unbalanced_velocity() const { return unbalanced_velocity_; }
  double fraction_before_impact() const { return fraction_before_impact_; }
  /// The load of the half step at the end of the last motion, on the blocks where they are now.
  ContactForce<D> load_of(const RigidContact<D>& contact) const;

  template <class Visit>
  void for_each_meeting(double duration, Visit visit) {
    search_.for_each_meeting(duration, visit);
  }

  /// Notes the contacts of the coming motion, or of the last one where none is predicted.
  void note_pressed(PressedPair& pair) const;
  /// After a solve that has not converged.
  const std::optional<Jam>& jam() const { return jam_; }

  // The stages of a motion, as in HardContacts.
  void begin() {
    jam_.reset();
    rest_.begin();
  }
  /// Does the coming motion repeat the last one, in which all blocks stood? Then no other stage is needed.
  bool rests(double duration) const { return rest_.lasts(duration); }
  void hold_blocks() {
    fraction_before_impact_ = 1;
    rest_.repeat();
  }
  /// The world has been edited.
  void forget_rest() { rest_.forget(); }
  /// Finds the contacts of a motion predicted without impulses, with those of the last motion as a start.
  void find(double duration);
  /// Contacts that the search has missed and that the predicted motion closes. False when there are none.
  bool find_more(double time, double duration);
  bool empty() const { return predicted_.empty(); }
  /// Does any contact close faster than by gravity, before the second half step?
  bool has_impact() const;
  /// Takes the memory of the end of the motion.
  void reserve() {
    next_known_.reserve(predicted_.size() + known_.size());
    first_.contacts.reserve(problem_.contacts.size());
    first_.rows.reserve(problem_.rows.size());
    work_of_islands_.reserve(problem_.islands.count());
    pauses_.reserve(blocks_.slot_count());
  }
  /// Makes the impulse problem of the first half from the contacts found, with its motions.
  void build();
  /// Changes of velocity so far are those of other contacts.
  void find_impacts(double time, double duration);
  /// Sets the targets from the motion predicted without impulses.
  void set_gap_targets(double duration);
  /// Solves from motions without impulses, and adds the changes of velocity. False when it does not converge;
  /// in a jam all impulses are none.
  bool solve(Half half, double duration);
  /// Adds the changes of velocity by its impulses.
  void push() const;
  bool correct_targets(double duration);

  // Parts for a solver of more than these contacts.
  ImpulseSettings settings_of(Half half, double duration) const;
  /// The velocities that the impulses of a half act on, without those of any contact.
  void set_motions(Half half);
  ImpulseProblem<D>& problem() { return problem_; }
  /// Copies the impulses of the problem to the contacts.
  void take_impulses_beside_points(Half half, const ImpulseResult& result);

  void apply_position_impulses(EnergyLedger& ledger);
  /// Blocks that points hold do not recover from penetration: they would be moved into the others.
  void find_at_end(std::span<const std::size_t> held_by_points);
  /// Makes the impulse problem of the second half, with its motions and targets.
  void set_velocity_targets();
  /// Takes the times of impact from the solution, then lowers restitution where impulses have made energy.
  /// True if the problem is to be solved again.
  bool improve_rebounds();
  void end_motion(EnergyLedger& ledger);

  void forget(std::int32_t slot) {
    rest_.forget();
    if (std::size_t(slot) < pauses_.size()) pauses_[std::size_t(slot)] = {};
    std::erase_if(known_,
                  [&](const RigidContact<D>& contact) { return contact.a == slot || contact.b == slot; });
  }
  /// The predicted motion is not made.
  void drop_motion() { next_iterations_ = 0; }
  /// False for what cannot be, after reading a snapshot.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(known_, duration_, touches_, iterations_, unbalanced_velocity_, pauses_, rest_);
  }

 private:
  VelocityChange<D>& changes() const { return integrator_.kicks(); }
  void warm_start(double duration);
  void add_support();
  bool can_move(std::size_t slot) const {
    return blocks_.lives(slot) && blocks_.moves(slot) && !integrator_.is_asleep(slot);
  }
  BlockMotion<D> motion(std::size_t slot) const;
  BlockMotion<D> motion_in(Half half, std::size_t slot) const;
  std::optional<Jam> find_jam(Half half, double ratio);
  void set_start(Half half);
  bool turns(std::int32_t mover) const;
  void set_slip_targets(double duration);
  double tolerance_of_rest() const;
  double standing_speed(double tolerance, double duration) const;
  bool stands(Half half, double duration);
  void take_impulses(const ImpulseResult& result);
  double recover(std::span<const std::size_t> held_by_points);
  void keep_pauses();
  bool are_contacts_kept() const;
  void replace_known(double duration);
  double twist_about_middle(const ImpulseContact<D>& of, const RigidContact<D>& contact);
  // Of rebounds, in rigid_contacts_rebounds.cpp.
  bool solves_whole() const { return !first_.contacts.empty(); }
  void keep_first_impulses();
  void take_first_rows();
  void take_back_first_impulses();
  void set_rebounds();
  bool match_times_of_impact();
  bool lower_rebounds();
  void set_targets();
  /// Calls `visit(row, impulse, is_normal)` for all impulses of a half step on a contact.
  template <class Visit>
  void for_each_impulse(std::size_t contact, Visit visit) const;
  ImpulseWork work_of(std::size_t contact) const;
  void sum_work_of_islands();
  double book(std::size_t contact, EnergyLedger& ledger);
  void book_motion(EnergyLedger& ledger);
  double gap_floor(const PredictedContact<D>& contact, std::size_t point) const;

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  Integrator<D>& integrator_;
  ManifoldSearch<D> search_;
  ImpulseRows<D> rows_;
  ImpulseSolver<D> solver_;
  ImpulseProblem<D> problem_;
  Rest<D> rest_;
  std::optional<Jam> jam_;
  Array<RigidContact<D>> known_;
  Array<RigidContact<D>> next_known_;
  Array<PredictedContact<D>> predicted_;
  ImpulseProblem<D> first_;  // that of the first half step, in the second one of a motion with rebounds
  Array<BlockMotion<D>> free_motions_;  // without impulses, while times of impact are found
  Array<SolverPause> pauses_;           // of each block, after the last motion
  Array<ImpulseWork> work_of_islands_;  // in a motion with rebounds
  int rebound_trials_ = 0;
  double duration_ = 0;  // of the last motion
  // Losses by all impulses of a motion so far, J, and the sum of the magnitudes of their works.
  double impact_loss_ = 0, friction_loss_ = 0, whole_work_ = 0;
  std::int64_t touches_ = 0;
  std::int64_t iterations_ = 0;       // of the motions so far
  std::int64_t next_iterations_ = 0;  // of the coming one
  double deepest_ = 0;
  double unbalanced_velocity_ = 0;       // of the last motion
  double next_unbalanced_velocity_ = 0;  // of the coming one
  double fraction_before_impact_ = 1;
};

template <int D>
template <class Visit>
void RigidContacts<D>::for_each_impulse(std::size_t c, Visit visit) const {
  const auto visit_all = [&](const ImpulseProblem<D>& problem, const ImpulseContact<D>& contact,
                             double sign) {
    std::int32_t i = 0;
    for (const ImpulseRow<D>& row : problem.rows_of(contact))
      visit(row, sign * row.impulse, i++ < contact.normal_count);
  };
  visit_all(problem_, problem_.contacts[c], 1);
  if (solves_whole()) visit_all(first_, first_.contacts[c], -1);
}

extern template class RigidContacts<2>;
extern template class RigidContacts<3>;

}  // namespace halfspace
