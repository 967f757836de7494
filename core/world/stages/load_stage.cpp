#include "world/stages/load_stage.h"

#include "world/loads/bolt_pass.h"

namespace halfspace {

template <int D>
void LoadStage<D>::load(std::int64_t step, double time, Stopwatch* stopwatch) {
  const auto lap = [&](Pass pass) {
    if (stopwatch) stopwatch->lap(pass);
  };
  ledger_.set_water(model_.water.empty() ? 0 : water_.load());
  if (!model_.water.empty()) lap(Pass::water);
  bolt_strain_ = 0;
  if (!model_.bolts.empty()) {
    load_by_bolts();
    lap(Pass::bolts);
  }
  if (!model_.blocks.bonds().empty()) {
    load_by_bonds(step, time);
    lap(Pass::bonds);
  }
  forces_.load_compounds();
}

template <int D>
void LoadStage<D>::load_by_bolts() {
  const BoltEnergy energy = halfspace::load_by_bolts(model_, forces_);
  bolt_strain_ = energy.strain;
  ledger_.set_contact_strain(ledger_.entries().strain + energy.strain);
  ledger_.add_bolt_loss(energy.loss);
}

/// Detection includes separated bonds from the next motion on.
template <int D>
void LoadStage<D>::load_by_bonds(std::int64_t step, double time) {
  BondEnergy energy;
  if (bonds_.load(step, time, energy)) contacts_.neighbors().invalidate();
  bond_strain_ = energy.strain;
  ledger_.set_contact_strain(ledger_.entries().strain + energy.strain);
  ledger_.add_fracture_loss(energy.fracture_loss);
  ledger_.add_friction_loss(energy.friction_loss);
}

template class LoadStage<2>;
template class LoadStage<3>;

}  // namespace halfspace
