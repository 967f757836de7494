#pragma once

#include "world/hard_contact/jam.h"
#include "world/hard_contact/point_contact_search.h"
#include "world/model/model.h"
#include "world/motion/integrator.h"
#include "world/motion/ledger.h"

namespace halfspace {

// Impulses enter velocity Verlet as constraints (RATTLE, Andersen 1983, with inequalities). The first half
// step gets the impulses that keep every corner in front of the face it would pass in the motion, the second
// those that stop its approach. For a corner in free flight both together are the merge of Li et al. 2015,
// section 4, with the step ended there: it flies freely up to its touch, and moves on with the block that it
// hit for the rest (section 3).

/// Contacts without springs as constraints between single points: of meshes and affine blocks, and of blocks
/// that a law bonds.
template <int D>
class PointContacts {
 public:
  PointContacts(const Model<D>& model, ContactList<D>& contacts, Integrator<D>& integrator, Memory* memory)
      : model_(model),
        blocks_(model.blocks),
        contacts_(contacts),
        integrator_(integrator),
        search_(model, contacts, integrator, memory),
        known_(memory),
        next_known_(memory),
        predicted_(memory),
        found_(memory) {}

  /// Those at the end of the last motion.
  const Array<PointContact<D>>& all() const { return known_; }
  std::int64_t touches() const { return touches_; }
  std::int64_t iterations() const { return iterations_; }
  /// The largest penetration so far where the solver did not converge, over the thickness of the thinner
  /// block.
  double deepest() const { return deepest_; }

  /// Notes the contacts of the coming motion, or of the last one where none is predicted.
  void note_pressed(PressedPair& pair) const;

  /// After the neighbour list has been renewed.
  void rebuild_surface() { search_.rebuild_surface(); }

  // The stages of a motion, as in HardContacts.
  /// Finds the contacts of a motion predicted without impulses, with those of the last motion as a start.
  void find(double time, double duration);
  /// Contacts that the search has missed and that the predicted motion closes. False when there are none.
  bool find_more(double time, double duration);
  bool empty() const { return predicted_.empty(); }
  /// Takes the memory of the end of the motion.
  void reserve() { next_known_.reserve(predicted_.size()); }
  /// Adds the changes of velocity by its impulses.
  void solve();
  /// Adds the changes of velocity by its impulses, times a factor.
  void push(double scale = 1);
  /// The contacts of the predicted motion, for a solver of more than these.
  Array<ContactConstraint<D>>& constraints() { return predicted_; }
  /// Gaps also change as their normals turn, which the linear constraints leave out: the constraint
  /// velocities are corrected by it. True when the correction is below the tolerance.
  bool correct(double duration);
  void apply_position_impulses(EnergyLedger& ledger);
  void find_at_end();
  /// An impact ends before elements deform: its loss is the work of its own impulses. If there is one, sets
  /// the velocities that they act on. False without any.
  bool begin_impact(bool is_other_impact);
  /// After its solve.
  void end_impact();
  void set_velocities();
  void end_motion(EnergyLedger& ledger);

  /// Drops the contacts of a predicted motion that was not made.
  void begin() { predicted_.clear(); }
  void forget() { known_.clear(); }
  /// The predicted motion is not made.
  void drop_motion() { next_iterations_ = 0; }

  /// False for what cannot be, after reading a snapshot.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(known_, touches_, iterations_);
  }

 private:
  VelocityChange<D>& changes() { return integrator_.kicks(); }
  const VelocityChange<D>& changes() const { return integrator_.kicks(); }
  Vector<D> kicked(const ContactConstraint<D>& at) const;
  bool is_approached(const ContactConstraint<D>& at) const;
  bool is_impact() const;
  double normal_work(const ContactConstraint<D>& at, const Vector<D>& velocity) const;
  void book_velocity_impulses(EnergyLedger& ledger);
  void exchange_known(EnergyLedger& ledger);
  double gap_floor_of(const ContactConstraint<D>& at) const;
  void begin(ContactConstraint<D>& at, double duration) const;
  void remember(Array<ContactConstraint<D>>& found, double time, double duration) const;
  void break_when_due(ContactConstraint<D>& at) const;
  Vector<D> velocity_of(const ContactConstraint<D>& at) const;
  double book(const ContactConstraint<D>& at, const Vector<D>& velocity, EnergyLedger& ledger) const;

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  ContactList<D>& contacts_;
  Integrator<D>& integrator_;
  PointContactSearch<D> search_;
  Array<PointContact<D>> known_;  // of the last motion, in order of their keys
  Array<PointContact<D>> next_known_;
  Array<ContactConstraint<D>> predicted_;
  Array<ContactConstraint<D>> found_;
  double motion_began_ = 0;           // time
  bool is_impact_ = false;            // some contact has closed in this motion
  std::int64_t touches_ = 0;          // so far
  std::int64_t iterations_ = 0;       // of the motions so far
  std::int64_t next_iterations_ = 0;  // of the coming one
  double deepest_ = 0;
};

extern template class PointContacts<2>;
extern template class PointContacts<3>;

}  // namespace halfspace
