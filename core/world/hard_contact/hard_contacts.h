#pragma once

#include "world/hard_contact/hard_contact_search.h"
#include "world/ledger.h"
#include "world/model/model.h"
#include "world/motion/integrator.h"

namespace halfspace {

// A law without a spring acts by impulses, which velocity Verlet takes in as a constraint (the RATTLE of
// Andersen 1983, with inequalities): the first kick gets those that keep every corner before the face that it
// would pass in the motion, the second those that keep it from going on behind. For a corner that comes near
// freely both together are the merge of Li et al. 2015, section 4, and it ends the step where that would: it
// flies freely up to its touch, and moves on with what it struck for the rest (section 3).

/// The contacts by laws without a spring, and what they do to a motion.
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
        planned_(memory),
        found_(memory) {}

  bool is_wanted() const { return model_.materials.laws().knows_no_spring(); }
  /// Those at the end of the last motion.
  const Array<ContactConstraint<D>>& all() const { return known_; }
  std::int64_t touches() const { return touches_; }
  std::int64_t iterations() const { return iterations_; }
  /// The depth to which any has come so far, where rounds have not sufficed, as a share of the thinner
  /// block's thickness.
  double deepest() const { return deepest_; }

  /// Takes note of the surfaces of meshes, after the neighbour list has been made anew.
  void rebuild_surface() { search_.rebuild_surface(); }
  /// Changes a motion that has been planned without, so that nothing passes through anything: false when it
  /// gets out of hand by that.
  bool predict(double time, double duration);
  /// Books what the first kick of the planned motion will do.
  void apply_position_impulses(EnergyLedger& ledger);
  /// Looks at the contacts at the end of a motion, before its second kick: none of them has an impulse yet.
  void look();
  /// Stops what goes on behind faces after that kick, and books it.
  void stop(EnergySample& sample, EnergyLedger& ledger);
  void forget() { known_.clear(); }

  /// False for what cannot be, after reading a snapshot.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(known_, touches_);
  }

 private:
  void solve(double duration);
  Vector<D> kicked(const ContactConstraint<D>& at) const;
  bool correct(double duration);
  bool is_approached(const ContactConstraint<D>& at) const;
  bool is_impact() const;
  double normal_work(const ContactConstraint<D>& at, const Vector<D>& velocity) const;
  void find_impact_losses();
  void book_second(EnergyLedger& ledger, bool is_impact);
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
  Array<ContactConstraint<D>> known_;  // of the last motion, in order of their keys
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
