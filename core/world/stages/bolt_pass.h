#pragma once

#include "world/contacts/force_pass.h"
#include "world/model/model.h"

namespace halfspace {

/// Strain energy of all bolts, and the loss by yield and rupture in one evaluation.
struct BoltEnergy {
  double strain = 0;
  double loss = 0;
};

/// Updates the bolts from the places of their blocks, and adds their forces to those of contacts.
template <int D>
BoltEnergy load_by_bolts(Model<D>& model, ForcePass<D>& forces);

extern template BoltEnergy load_by_bolts(Model<2>&, ForcePass<2>&);
extern template BoltEnergy load_by_bolts(Model<3>&, ForcePass<3>&);

}  // namespace halfspace
