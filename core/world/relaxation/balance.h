#pragma once

#include "world/stages/state.h"

namespace halfspace {

/// Unbalanced forces on blocks and nodes.
struct Balance {
  double mean = 0;           // sum of unbalanced forces over sum of all forces; 0 if there are none
  double largest = 0;        // maximum ratio of a block or node; over the mean force if that is larger
  double largest_force = 0;  // maximum unbalanced force, N
  std::int32_t block = -1;   // on which it acts; for a node, a surface cell; -1: none
};

/// Working memory of balance_of().
struct BalanceRoom {
  template <int D>
  BalanceRoom(const Blocks<D>& blocks, Memory* memory)
      : of_block(blocks.slot_count(), 0, memory), of_node(blocks.meshes().node_count(), 0, memory) {}

  Array<double> of_block;  // sum of the magnitudes of all forces on each
  Array<double> of_node;
};

/// Computes the balance of the last forces. Torques, and generalized forces of strain, count as forces at the
/// block's radius. Prescribed motion has no unbalanced force. `room`: for all blocks and nodes.
template <int D>
Balance balance_of(const State<D>& state, BalanceRoom& room);

extern template Balance balance_of(const State<2>&, BalanceRoom&);
extern template Balance balance_of(const State<3>&, BalanceRoom&);

/// Estimates the angular frequency of the slowest motion of a world by the Rayleigh quotient of displacements
/// and the force changes due to them (Underwood 1983). Twice this frequency is the critical mass damping.
template <int D>
class SlowestMotion {
 public:
  /// Allocates memory for all current blocks and nodes.
  SlowestMotion(const Model<D>& model, Memory* memory)
      : model_(model),
        places_(model.blocks.slot_count() + model.blocks.meshes().node_count(), Vector<D>::Zero(), memory),
        forces_(places_.size(), Vector<D>::Zero(), memory) {}

  /// Returns the critical mass damping of the motion since the last call, 1/s, or a negative number if it is
  /// undefined. Precondition: forces are evaluated.
  double look();

 private:
  const Model<D>& model_;
  bool has_looked_ = false;
  Array<Vector<D>> places_;  // of blocks, then of nodes, at the last call of look()
  Array<Vector<D>> forces_;
};

extern template class SlowestMotion<2>;
extern template class SlowestMotion<3>;

}  // namespace halfspace
