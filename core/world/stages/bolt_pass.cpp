#include "world/stages/bolt_pass.h"

namespace halfspace {

/// The force acts along the line through both ends, so it conserves angular momentum.
template <int D>
BoltEnergy load_by_bolts(Model<D>& model, ForcePass<D>& forces) {
  const bool are_held = model.blocks.bonds().are_held();
  BoltEnergy energy;
  for (Bolt<D>& bolt : model.bolts.all()) {
    const BoltEnds<D> ends(model.blocks, bolt);
    const Vector<D> way = ends.b - ends.a;
    const double length = way.norm(), dissipated = bolt.dissipated;
    stretch(bolt, length - bolt.unstressed_length, are_held);
    energy.strain += bolt.strain_energy();
    energy.loss += bolt.dissipated - dissipated;
    if (bolt.tension == 0 || length == 0) continue;
    const Vector<D> on_a = bolt.tension / length * way;
    if (bolt.a >= 0) forces.add_load(std::size_t(bolt.a), on_a, on_a * ends.arm_a.transpose());
    if (bolt.b >= 0) forces.add_load(std::size_t(bolt.b), -on_a, -on_a * ends.arm_b.transpose());
  }
  return energy;
}

template BoltEnergy load_by_bolts(Model<2>&, ForcePass<2>&);
template BoltEnergy load_by_bolts(Model<3>&, ForcePass<3>&);

}  // namespace halfspace
