#pragma once

#include "world/contacts/contact_list.h"
#include "world/hard_contact/impulse_solver.h"
#include "world/hard_contact/rigid_contact.h"
#include "world/ledger.h"
#include "world/model/model.h"
#include "world/motion/integrator.h"

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
        contacts_(contacts),
        integrator_(integrator),
        solver_(memory),
        problem_(memory),
        known_(memory),
        next_known_(memory),
        planned_(memory),
        ahead_(memory),
        allowance_(memory) {}

  /// Those at the end of the last motion, in order of their blocks.
  const Array<RigidContact<D>>& all() const { return known_; }
  std::int64_t touches() const { return touches_; }
  std::int64_t iterations() const { return iterations_; }
  /// The largest penetration so far over the thickness of the thinner block.
  double deepest() const { return deepest_; }
  /// On b, of the half step at the end of the last motion.
  Vector<D> force_of(const RigidContact<D>& contact) const;

  // The stages of a motion, as in HardContacts.
  bool predict(double time, double duration);
  void apply_position_impulses(EnergyLedger& ledger);
  void find_at_end(EnergyLedger& ledger);
  void stop_approach(EnergyLedger& ledger);

  void forget() { known_.clear(); }
  /// False for what cannot be, after reading a snapshot.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(known_, duration_, touches_);
  }

 private:
  /// A contact of the present motion.
  struct Planned : RigidContact<D> {
    std::array<double, max_manifold_points<D>>
        rebound{};  // m/s, of opening at the motion's end, by an impact
    std::array<double, max_manifold_points<D>> rebound_gap{};  // m, there
    std::array<bool, max_manifold_points<D>> was_loaded{};     // in the last motion
    bool is_new = true;
    bool is_impact = false;
  };

  /// Where friction acts.
  struct Patch {
    Vector<D> center;  // from the centroid of a
    double radius;
  };

  VelocityChange<D>& changes() { return integrator_.kicks(); }
  PosedBlock<D> now(std::size_t slot) const;
  PosedBlock<D> predicted(std::size_t slot) const;
  double reach(const RigidContact<D>& contact) const;
  double settled_gap(const RigidContact<D>& contact) const;
  double separation_margin(std::size_t a, std::size_t b) const { return allowance_[a] + allowance_[b]; }

  void pose_ahead(double duration);
  void find(double duration);
  bool find_more(double time, double duration);
  void start(Planned& contact, double time, double duration) const;
  void warm_start(double duration);
  void build_rows(const Array<Planned>& contacts);
  Patch patch_of(const Planned& at, const std::array<Vector<D>, max_manifold_points<D>>& arm) const;
  void set_gaps(Planned& contact) const;
  void find_impacts(double time, double duration);
  void set_position_targets(double duration);
  bool correct_targets(double duration);
  void set_velocity_targets();
  BlockMotion<D> motion(std::size_t slot) const;
  void set_motions();
  void set_masses();
  void set_motions_at_half_step();
  bool solve(double duration);
  double recover();
  double book(std::size_t contact, EnergyLedger& ledger);
  double stored_work(std::size_t contact);
  double gap_floor(const Planned& contact, std::size_t point) const;
  bool names_features(const Manifold<D>& manifold, std::int32_t a, std::int32_t b) const;
  double predicted_gap(const Planned& contact, std::size_t point) const;

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  ContactList<D>& contacts_;
  Integrator<D>& integrator_;
  ImpulseSolver<D> solver_;
  ImpulseProblem<D> problem_;
  Array<RigidContact<D>> known_;
  Array<RigidContact<D>> next_known_;
  Array<Planned> planned_;
  Array<PosedBlock<D>> ahead_;  // of each block, at the end of the motion by its velocity now
  Array<double> allowance_;     // m, that a block may deviate from that
  double duration_ = 0;         // of the last motion
  std::int64_t touches_ = 0;
  std::int64_t iterations_ = 0;
  double deepest_ = 0;
};

extern template class RigidContacts<2>;
extern template class RigidContacts<3>;

}  // namespace halfspace
