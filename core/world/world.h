#pragma once

#include <cstdint>
#include <span>

#include "block/mesh/surface.h"
#include "threads/interrupt.h"
#include "world/placed.h"
#include "world/stages/stages.h"
#include "world/stages/state.h"

namespace halfspace {

/// A world is a model, a state, and the stages that take both from one time to the next. Edits change model
/// and state.
template <int D>
class World {
 public:
  /// The threads and the interrupt, if any, must outlive the world.
  World(const WorldSettings<D>& settings, Memory* memory, Threads* threads = nullptr,
        Interrupt* interrupt = nullptr)
      : model_(settings, memory), state_(model_, threads), stages_(state_), interrupt_(interrupt) {}

  // Edits.
  std::int32_t add_material(double density);
  /// False, without any change, if the stiffness of a cell of that material would not be finite.
  bool set_elasticity(std::int32_t material, const Elasticity& elasticity);
  void set_default_law(const ContactLaw& law);
  void set_law(std::int32_t a, std::int32_t b, const ContactLaw& law);
  std::int32_t add_block(const Shape<D>& shape, BlockKind kind, std::int32_t material,
                         const Vector<D>& position, const Rotation<D>& rotation);
  /// Adds a compound of convex parts, with its centroid at `pose`. `poses`: of the parts, in one frame. If
  /// parts overlap, or memory runs out, nothing has changed.
  PlacedCompound add_compound(std::span<const Shape<D>* const> shapes, std::span<const Pose<D>> poses,
                              BlockKind kind, std::int32_t material, const Pose<D>& pose);
  void remove_block(std::int32_t slot);
  void remove_compound(std::int32_t slot);
  void set_pose(std::int32_t slot, const Vector<D>& position, const Rotation<D>& rotation);
  void set_velocity(std::int32_t slot, const Vector<D>& velocity, const Angular<D>& spin);
  /// Adds a mesh at a pose, with a material per cell, and the cells of its surface as blocks. If memory runs
  /// out, nothing has changed.
  PlacedMesh add_mesh(const Mesh<D>& mesh, const Pose<D>& pose, std::span<const std::int32_t> cell_materials);
  void remove_mesh(std::int32_t body);
  /// Removes some, but not all, cells of a body; their neighbours become part of its surface. Adds the nodal
  /// forces of their stress and weight to `released`, one per node of the body. A node without cells keeps
  /// its position and has no mass. On a fault, or if memory runs out, nothing has changed.
  MeshFaultReport remove_cells(std::int32_t body, std::span<const std::int32_t> cells,
                               std::span<Vector<D>> released);
  /// Sets the stress of a body's cells in their current deformation. False, without any change, for a stress
  /// out of bounds.
  bool set_body_stress(std::int32_t body, const StressField<D>& field);
  /// Bonds two blocks along their current common face. False if there is none, or if they are joined already.
  bool bond_pair(std::int32_t a, std::int32_t b, const BondLaw& law);
  /// Bonds all pairs of blocks of two materials along their common faces. Returns the number of bonds.
  std::int64_t bond_materials(std::int32_t material_a, std::int32_t material_b, const BondLaw& law);
  /// Held bonds do not fail.
  void hold_bonds(bool are_held);
  /// Sets the water table and the density of water, times the factor of its pressure. An empty table is no
  /// water.
  void set_water(WaterTable<D>&& table, double density);
  /// Adds a bolt between two places, one of which a block carries that moves. Returns its number.
  std::int64_t add_bolt(Bolt<D> bolt, const Vector<D>& at_a, const Vector<D>& at_b, double pretension);
  void remove_bolt(std::size_t index);
  /// Held components of a node's velocity are constant; bit k of `held` is for component k.
  void hold_node(std::size_t node, std::uint8_t held);
  void set_node_velocity(std::size_t node, const Vector<D>& velocity);
  void set_node_force(std::size_t node, const Vector<D>& force);
  /// The dashpots of nodes of a body: force over velocity of each, N s/m.
  void set_node_viscosity(std::int32_t body, std::span<const std::int32_t> nodes, const Tensor<D>& viscosity);
  /// Updates the surface blocks of a body after edits of its nodes.
  void end_node_edits(std::int32_t body);
  /// Only for affine blocks.
  void set_deformation(std::int32_t slot, const Tensor<D>& gradient, const Tensor<D>& rate);
  void set_stress(std::int32_t slot, const Tensor<D>& stress);
  /// `traction`: force per area of a face, in 2D an edge, of the undeformed shape, Pa.
  void add_surface_load(std::int32_t slot, int face, const Vector<D>& traction);
  void clear_surface_loads(std::int32_t slot);
  std::int32_t add_table(std::span<const double> times, std::span<const Vector<3>> values);
  void add_action(const Action<D>& action);
  void add_node_action(const NodeAction& action, std::span<const std::int32_t> nodes,
                       std::span<const Vector<D>> scales);
  /// Ends the actions on a block; those on all blocks if the slot is -1.
  void end_actions(std::int32_t slot);
  void end_node_actions(std::int32_t body);
  /// Only for rigid blocks. Bit k: the velocity along axis k stays; bit D: the block does not rotate.
  void hold_block(std::int32_t slot, std::uint8_t components);
  /// Only for prescribed blocks, between steps: contacts and forces stay.
  void prescribe_velocity(std::int32_t slot, const Vector<D>& velocity, const Angular<D>& spin);
  void set_applied_force(std::int32_t slot, const Vector<D>& force, const Angular<D>& torque);
  /// Sets the force of a contact's shear spring on b; only its part in the contact plane counts. False if
  /// there is no shear spring.
  bool set_shear_force(std::size_t contact, const Vector<D>& force);

  void set_gravity(const Vector<D>& gravity);
  void set_damping(double local_damping, double mass_damping);
  void set_time_step(double time_step);
  /// Divides all given strengths of laws and bonds by this factor: friction, cohesion, tensile strength.
  void set_strength_factor(double factor);

  // Time.
  /// Updates time step, contacts, forces and ledger after edits.
  StepResult prepare();
  /// One step of velocity Verlet. If memory runs out, the world is as before; if the motion is unstable, no
  /// block has moved.
  StepResult step();
  /// Neighbour search, if the list needs a rebuild, and detection.
  void detect() { stages_.detect(); }
  /// Computes the contact forces on blocks. `elapsed`: time over which shear springs grow, s.
  void evaluate_forces_for_host(double elapsed);

  const Model<D>& model() const { return model_; }
  const Blocks<D>& blocks() const { return model_.blocks; }
  const State<D>& state() const { return state_; }
  /// For what drives a world from outside: relaxation, shares, snapshots.
  State<D>& state() { return state_; }
  Stages<D>& stages() { return stages_; }

 private:
  MeshFaultReport add_surface(std::int32_t body, std::span<const SurfaceSimplex<D>> simplices,
                              std::span<const std::int32_t> cell_materials);
  void weigh_surface(std::int32_t body, Array<int>& bearing);
  StepResult prepare_and_predict(Motion& motion);
  StepResult predict_changed(Motion& motion);
  StepResult predict_rest(Motion& motion);
  StepResult predict_next(Motion& motion);
  void look_for_sleep();

  Model<D> model_;
  State<D> state_;
  Stages<D> stages_;
  Interrupt* interrupt_;
};

extern template class World<2>;
extern template class World<3>;

}  // namespace halfspace
