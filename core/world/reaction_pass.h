#pragma once

#include "world/integrator.h"
#include "world/ledger.h"
#include "world/model.h"
#include "world/reaction_search.h"

namespace halfspace {

// A law without a spring acts by impulses, which velocity Verlet takes in as a constraint (the RATTLE of
// Andersen 1983, with inequalities): the first kick gets those that keep every corner before the face that it
// would pass in the motion, the second those that keep it from going on behind. For a corner that comes near
// freely both together are the merge of Li et al. 2015, section 4, and it ends the step where that would: it
// flies freely up to its touch, and moves on with what it struck for the rest (section 3).

/// The contacts by laws without a spring, and what they do to a motion.
template <int D>
class ReactionPass {
 public:
  ReactionPass(const Model<D>& model, ContactList<D>& contacts, Integrator<D>& integrator, Memory* memory)
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
  const Array<Reaction<D>>& all() const { return known_; }
  std::int64_t touches() const { return touches_; }
  std::int64_t rounds() const { return rounds_; }
  /// The depth to which any has come so far, where rounds have not sufficed, as a share of the thinner
  /// block's thickness.
  double deepest() const { return deepest_; }

  /// Takes note of the surfaces of meshes, after the neighbour list has been made anew.
  void survey() { search_.survey(); }
  /// Changes a motion that has been planned without, so that nothing passes through anything: false when it
  /// gets out of hand by that.
  bool plan(double time, double duration);
  /// Books what the first kick of the planned motion will do.
  void book_first(EnergyLedger& ledger);
  /// Looks at the contacts at the end of a motion, before its second kick: none of them has an impulse yet.
  void look();
  /// Stops what goes on behind faces after that kick, and books it.
  void stop(Stock& stock, EnergyLedger& ledger);
  void forget() { known_.clear(); }

  /// False for what cannot be, after reading a snapshot.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(known_, touches_);
  }

 private:
  void solve(double duration);
  Vector<D> kicked(const Reaction<D>& at) const;
  bool correct(double duration);
  bool is_approached(const Reaction<D>& at) const;
  bool is_blow() const;
  double normal_work(const Reaction<D>& at, const Vector<D>& velocity) const;
  void find_blow_losses();
  void book_second(EnergyLedger& ledger, bool is_blow);
  void exchange_known(EnergyLedger& ledger);
  double least_gap_of(const Reaction<D>& at) const;
  void begin(Reaction<D>& at, double duration) const;
  bool find_more(double time, double duration);
  void remember(Array<Reaction<D>>& found, double time, double duration) const;
  void break_when_due(Reaction<D>& at) const;
  Vector<D> velocity_of(const Reaction<D>& at) const;
  double book(const Reaction<D>& at, const Vector<D>& velocity, EnergyLedger& ledger) const;

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  ContactList<D>& contacts_;
  Integrator<D>& integrator_;
  ReactionSearch<D> search_;
  Array<Reaction<D>> known_;  // of the last motion, in order of their keys
  Array<Reaction<D>> planned_;
  Array<Reaction<D>> found_;
  double motion_began_ = 0;   // time
  std::int64_t touches_ = 0;  // so far
  std::int64_t rounds_ = 0;
  double deepest_ = 0;
};

extern template class ReactionPass<2>;
extern template class ReactionPass<3>;

}  // namespace halfspace
