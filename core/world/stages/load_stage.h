#pragma once

#include <cstdint>
#include <tuple>

#include "world/contacts/bond_pass.h"
#include "world/contacts/force_pass.h"
#include "world/ledger.h"
#include "world/loads/water_pass.h"
#include "world/model/model.h"
#include "world/share/share.h"
#include "world/stopwatch.h"

namespace halfspace {

/// Adds to the forces of contacts, once they are gathered, those of water, bolts and bonds, books their
/// energies, and passes the loads of parts on to their compounds.
template <int D>
class LoadStage {
 public:
  LoadStage(Model<D>& model, ContactList<D>& contacts, ForcePass<D>& forces, const Share& share,
            EnergyLedger& ledger, Threads* threads, Memory* memory)
      : model_(model),
        contacts_(contacts),
        forces_(forces),
        ledger_(ledger),
        bonds_(model),
        water_(model, forces, share, threads, memory) {}

  /// Reserves memory for the water table that comes.
  void fit_water() { water_.fit_room(); }
  /// Reserves memory for the blocks there are.
  void fit_room() {
    if (!model_.water.empty()) fit_water();
  }
  /// Call when the neighbour list is new.
  void hand_over_bonds() {
    if (!model_.blocks.bonds().empty()) bonds_.hand_over(contacts_);
  }
  /// `step`, `time`: at the end of the motion, to which the failures of bonds belong.
  void load(std::int64_t step, double time, Stopwatch* stopwatch);

  double bond_strain() const { return bond_strain_; }
  double bolt_strain() const { return bolt_strain_; }
  auto state() { return std::tie(bond_strain_, bolt_strain_); }
  template <class Archive>
  void visit(Archive& archive) {
    archive(bond_strain_, bolt_strain_);
  }

 private:
  void load_by_bolts();
  void load_by_bonds(std::int64_t step, double time);

  Model<D>& model_;
  ContactList<D>& contacts_;
  ForcePass<D>& forces_;
  EnergyLedger& ledger_;
  BondPass<D> bonds_;
  WaterPass<D> water_;
  double bond_strain_ = 0;  // J
  double bolt_strain_ = 0;  // J
};

extern template class LoadStage<2>;
extern template class LoadStage<3>;

}  // namespace halfspace
