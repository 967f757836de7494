#pragma once

#include "world/contacts/contact_list.h"
#include "world/contacts/force_pass.h"
#include "world/hard_contact/hard_contacts.h"
#include "world/model/model.h"
#include "world/motion/integrator.h"

namespace halfspace {

/// The distance of the forces on blocks and nodes from balance.
struct Balance {
  double mean = 0;           // all that is unbalanced over all that acts; 0 where nothing acts
  double largest = 0;        // of a single block or node; where next to nothing acts, over the mean force
  double largest_force = 0;  // that is unbalanced
  std::int32_t block = -1;   // that it acts on, of a node a cell at the surface; -1: none
};

/// The memory that measuring the balance takes.
struct BalanceRoom {
  template <int D>
  BalanceRoom(const Blocks<D>& blocks, Memory* memory)
      : of_block(blocks.slot_count(), 0, memory), of_node(blocks.meshes().node_count(), 0, memory) {}

  Array<double> of_block;  // the sizes of all forces on each
  Array<double> of_node;
};

/// Measures the balance of the last forces; the room is for as many blocks and nodes as there are. Torques
/// count as forces at a block's radius, and so does what drives strain. Where motion is prescribed nothing is
/// unbalanced.
template <int D>
Balance balance_of(const Model<D>& model, const ContactList<D>& contacts, const ForcePass<D>& forces,
                   const HardContacts<D>& hard_contacts, const Integrator<D>& integrator, BalanceRoom& room);

extern template Balance balance_of(const Model<2>&, const ContactList<2>&, const ForcePass<2>&,
                                   const HardContacts<2>&, const Integrator<2>&, BalanceRoom&);
extern template Balance balance_of(const Model<3>&, const ContactList<3>&, const ForcePass<3>&,
                                   const HardContacts<3>&, const Integrator<3>&, BalanceRoom&);

/// The way in which a world is brought to rest.
struct Relaxation {
  bool by_largest = false;  // else by the mean
  double ratio = 1e-5;
  std::int64_t max_steps = 1000000;
  double local_damping = 0.1;
  bool is_adaptive = true;  // mass damping as the slowest motion that is left wants it
  bool holds_bonds = true;
  double max_displacement =
      0;  // share of its size that any block or cell may move, or it falls; 0: without end
};

/// Finds out how fast the slowest motion of a world swings, by Rayleigh's quotient of what it has moved and
/// of what forces have changed by that (Underwood 1983). Twice that frequency is the mass damping under which
/// it comes to rest soonest.
template <int D>
class SlowestMotion {
 public:
  /// Takes memory for all blocks and nodes that there are.
  SlowestMotion(const Model<D>& model, Memory* memory)
      : model_(model),
        places_(model.blocks.slot_count() + model.blocks.meshes().node_count(), Vector<D>::Zero(), memory),
        forces_(places_.size(), Vector<D>::Zero(), memory) {}

  /// Looks at the world: the mass damping that is wanted since the last look, or a negative number when it
  /// cannot be told. Forces are known.
  double look();

 private:
  const Model<D>& model_;
  bool has_looked_ = false;
  Array<Vector<D>> places_;  // of blocks, then of nodes, at the last look
  Array<Vector<D>> forces_;
};

extern template class SlowestMotion<2>;
extern template class SlowestMotion<3>;

}  // namespace halfspace
