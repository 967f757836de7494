#pragma once

#include "threads/threads.h"
#include "world/contacts/force_pass.h"
#include "world/model/model.h"
#include "world/model/share.h"

namespace halfspace {

/// Adds the load of water to that of contacts.
template <int D>
class WaterPass {
 public:
  WaterPass(const Model<D>& model, ForcePass<D>& forces, const Share& share, Threads* threads, Memory* memory)
      : model_(model), forces_(forces), share_(share), threads_(threads), energy_(memory) {}

  /// Reserves its memory.
  void fit_room();
  /// Adds the loads of all blocks that are not fixed, of a share those of its own. Returns their potential
  /// energy.
  double load();

 private:
  const Model<D>& model_;
  ForcePass<D>& forces_;
  const Share& share_;
  Threads* threads_;
  Array<double> energy_;  // per strip of blocks
};

extern template class WaterPass<2>;
extern template class WaterPass<3>;

}  // namespace halfspace
