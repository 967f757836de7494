#pragma once

#include "world/hard_contact/hard_contact_search.h"
#include "world/ledger.h"
#include "world/model/model.h"
#include "world/motion/integrator.h"

namespace halfspace {

// A law without springs acts by impulses, which velocity Verlet takes as constraints (RATTLE, Andersen 1983,
// with inequalities). The first half step gets the impulses that keep every corner in front of the face it
// would pass in the motion, the second those that stop its approach. For a corner in free flight both
// together are the merge of Li et al. 2015, section 4, with the step ended there: it flies freely up to its
// touch, and moves on with the block that it hit for the rest (section 3).

/// The contacts of laws without springs, and their impulses. In a world without such laws its stages do
/// nothing.
template <int D>
class HardContacts {
 public:
  HardContacts(const Model<D>& model, ContactList<D>& contacts, Integrator<D>& integrator, Memory* memory)
      : model_(model),
        blocks_(model.blocks),
        contacts_(contacts),
        integrator_(integrator),
        search_(model, contacts, integrator, memory),
        known_(memory),
        next_known_(memory),
        planned_(memory),
        found_(memory) {}

  /// Does any law have no springs?
  bool is_used() const { return model_.materials.laws().knows_no_spring(); }
  /// Those at the end of the last motion.
  const Array<HardContact<D>>& all() const { return known_; }
  std::int64_t touches() const { return touches_; }
  std::int64_t iterations() const { return iterations_; }
  /// The largest penetration so far where the solver did not converge, over the thickness of the thinner
  /// block.
  double deepest() const { return deepest_; }

  /// After the neighbour list has been renewed.
  void rebuild_surface() {
    if (is_used()) search_.rebuild_surface();
  }

  // The stages of a motion, in their order.
  /// Sets all impulses of the coming motion to none.
  void begin(double duration) {
    if (is_used()) changes().begin(duration);
  }
  /// Changes a motion predicted without impulses so that no block passes into another. False when the motion
  /// diverges.
  bool predict(double time, double duration);
  /// Adds the work of the impulses of the first half step to the ledger.
  void apply_position_impulses(EnergyLedger& ledger);
  /// Updates the contacts at the end of the motion, before its second half step: none has an impulse yet.
  void find_at_end();
  /// Stops approach at all contacts after the second half step, and adds the work to the ledger.
  void stop_approach(EnergySample& sample, EnergyLedger& ledger);

  void forget() { known_.clear(); }

  /// False for what cannot be, after reading a snapshot.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(known_, touches_);
  }

 private:
  VelocityChange<D>& changes() { return integrator_.kicks(); }
  const VelocityChange<D>& changes() const { return integrator_.kicks(); }
  void solve(double duration);
  Vector<D> kicked(const ContactConstraint<D>& at) const;
  bool correct(double duration);
  bool is_approached(const ContactConstraint<D>& at) const;
  bool is_impact() const;
  double normal_work(const ContactConstraint<D>& at, const Vector<D>& velocity) const;
  void find_impact_losses();
  void book_velocity_impulses(EnergyLedger& ledger, bool is_impact);
  void exchange_known(EnergyLedger& ledger);
  double gap_floor_of(const ContactConstraint<D>& at) const;
  void begin(ContactConstraint<D>& at, double duration) const;
  bool find_more(double time, double duration);
  void remember(Array<ContactConstraint<D>>& found, double time, double duration) const;
  void break_when_due(ContactConstraint<D>& at) const;
  Vector<D> velocity_of(const ContactConstraint<D>& at) const;
  double book(const ContactConstraint<D>& at, const Vector<D>& velocity, EnergyLedger& ledger) const;

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  ContactList<D>& contacts_;
  Integrator<D>& integrator_;
  HardContactSearch<D> search_;
  Array<HardContact<D>> known_;  // of the last motion, in order of their keys
  Array<HardContact<D>> next_known_;
  Array<ContactConstraint<D>> planned_;
  Array<ContactConstraint<D>> found_;
  double motion_began_ = 0;   // time
  std::int64_t touches_ = 0;  // so far
  std::int64_t iterations_ = 0;
  double deepest_ = 0;
};

extern template class HardContacts<2>;
extern template class HardContacts<3>;

}  // namespace halfspace
