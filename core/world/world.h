#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>

#include "block/mesh/surface.h"
#include "threads/interrupt.h"
#include "world/contacts/contact_list.h"
#include "world/contacts/force_pass.h"
#include "world/hard_contact/hard_contacts.h"
#include "world/ledger.h"
#include "world/model/model.h"
#include "world/motion/clock.h"
#include "world/motion/continuous_collision.h"
#include "world/motion/integrator.h"
#include "world/motion/penetration_bound.h"
#include "world/motion/stable_step.h"
#include "world/relaxation/balance.h"
#include "world/share/assembly.h"
#include "world/share/block_record.h"
#include "world/share/share.h"
#include "world/stages/contact_stage.h"
#include "world/stages/load_stage.h"
#include "world/stopwatch.h"

namespace halfspace {

/// overworked: the step has been divided, and its motions have taken too many iterations.
enum class StepResult { ok, unstable, no_time_step, too_fast, inverted, overworked, interrupted };

/// The body of an added mesh, or the fault of the mesh.
struct PlacedMesh {
  MeshFaultReport report;
  std::int32_t body = -1;
};

/// Two parts of a compound that overlap; depth 0: none do.
struct PartOverlap {
  std::int32_t a = -1;
  std::int32_t b = -1;
  double depth = 0;  // m
};

/// An added compound, unless its parts overlap.
struct PlacedCompound {
  PartOverlap overlap;
  std::int32_t block = -1;
};

/// A stress that is linear in position.
template <int D>
struct StressField {
  Tensor<D> at(const Vector<D>& place) const {
    Tensor<D> stress = at_origin;
    for (int k = 0; k < D; ++k) stress += place[k] * gradient[std::size_t(k)];
    return stress;
  }
  Tensor<D> at_origin;
  std::array<Tensor<D>, D> gradient;  // along each axis
};

/// The result of a relaxation.
struct Relaxed {
  StepResult result = StepResult::ok;
  bool is_at_rest = false;
  bool has_failed = false;  // some block has moved beyond max_displacement
  std::int64_t steps = 0;
  Balance balance;
};

/// The needs of the next motion of a share.
struct SharedMotion {
  StepResult result = StepResult::ok;  // too_fast: it would have to be divided
  bool needs_list = false;             // blocks may meet others that are not in the list in use
  bool needs_assembly = false;         // an entry face has to be told to other shares
};

/// The momentum of the own blocks of a share; those of meshes are not among them.
template <int D>
struct Momentum {
  Vector<D> linear = Vector<D>::Zero();     // N s
  Angular<D> angular = Angular<D>::Zero();  // about the origin, N m s
};

/// Maximum number of motions in one call of step().
constexpr int max_motions = 1 << 14;

/// Maximum number of iterations for the impulses of a divided step, over those that one solve may take.
constexpr std::int64_t max_divided_solves = 1 << 10;

/// Blocks, their contacts, and time. Owns the parts of a world and orders them: a step predicts a motion,
/// makes its first half, finds the contacts at the new positions, computes their forces, makes the second
/// half, and books the energy.
template <int D>
class World {
 public:
  /// The threads and the interrupt, if any, must outlive the world.
  World(const WorldSettings<D>& settings, Memory* memory, Threads* threads = nullptr,
        Interrupt* interrupt = nullptr);

  // Edits.
  std::int32_t add_material(double density);
  double density(std::int32_t material) const { return model_.materials.density(material); }
  std::int32_t material_count() const { return model_.materials.count(); }
  /// False, without any change, if the stiffness of a cell of that material would not be finite.
  bool set_elasticity(std::int32_t material, const Elasticity& elasticity);
  const Elasticity& elasticity(std::int32_t material) const { return model_.materials.elasticity(material); }
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
  std::int32_t table_count() const { return model_.actions.tables().count(); }
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

  // Stages.
  /// Neighbour search, if the list needs a rebuild, and detection.
  void detect();
  bool is_detected() const { return contacts_.are_found(); }
  /// Computes the contact forces on blocks. `elapsed`: time over which shear springs grow, s.
  void evaluate_forces_for_host(double elapsed);
  /// One step of velocity Verlet. If memory runs out, the world is as before; if the motion is unstable, no
  /// block has moved.
  StepResult step();
  /// Dynamic relaxation: steps under damping until forces balance. At rest, sets all free velocities to 0.
  /// Damping and bonds are as before.
  Relaxed relax(const Relaxation& relaxation);
  Balance balance();
  void set_gravity(const Vector<D>& gravity);
  void set_damping(double local_damping, double mass_damping);
  void set_time_step(double time_step);
  /// Divides all given strengths of laws and bonds by this factor: friction, cohesion, tensile strength.
  void set_strength_factor(double factor);
  /// Updates time step, contacts, forces and ledger after edits.
  StepResult prepare();

  // Shares of a world, in world/share: see there.
  Share& share() { return share_; }
  /// Names the living blocks, in ascending order.
  void set_keys(std::span<const std::int64_t> keys);
  const Share& share() const { return share_; }
  /// The slot of the block with a key; -1: none.
  std::int32_t living_slot_of(std::int64_t key, std::size_t near = 0) const;
  /// The record of a block, from which assemble() makes it in another world.
  void record(std::size_t slot, bool with_outline, BlockRecord<D>& out);
  /// Makes this new and empty world one of the given blocks, in ascending order of keys.
  AssemblyFault assemble(World& from, std::span<const PackedBlock> blocks);
  /// prepare() in pieces: contacts and forces; then, with the loads of copies set, accelerations.
  StepResult begin_in_share();
  void end_beginning();
  /// step() in pieces: a prediction; a new list where any share needs one; the motion and its forces; then,
  /// with the loads of copies set, the velocities at its end.
  SharedMotion plan_in_share();
  SharedMotion renew_list_in_share();
  void move_and_load();
  void end_step_in_share();
  /// Replaces the loads of a copy's contacts by those that its owner has computed. `virial`: of an affine
  /// one.
  void set_loads(std::size_t slot, const Vector<D>& force, const Angular<D>& torque, const Tensor<D>& virial);
  EnergyLedger::Sums ledger_sums() const { return ledger_.sums(); }
  void set_ledger_sums(const EnergyLedger::Sums& sums) {
    ledger_.set_sums(sums);
    share_.take_all_losses();
  }
  Momentum<D> momentum() const;
  /// The properties that all shares of this world have, or of the world of which it is a share.
  Share::Common common_of_shares();
  /// Twice the largest distance of the centroids of two blocks that the next list may hold.
  double halo();

  // Queries.
  const Blocks<D>& blocks() const { return model_.blocks; }
  std::size_t contact_count() const { return contacts_.count(); }
  Contact<D> contact(std::size_t c) const { return contacts_.contact(c); }
  /// False until forces have been evaluated for the current contacts.
  bool knows_forces() const { return forces_.are_known(); }
  const ContactForce<D>& contact_force(std::size_t c) const { return forces_.of_contact(c); }
  const Candidate<D>& candidate_of(std::size_t contact) const { return contacts_.pair_of(contact); }
  std::optional<std::size_t> contact_between(std::int32_t a, std::int32_t b) const {
    return contacts_.contact_between(a, b);
  }
  const NeighborList<D>& candidates() const { return contacts_.neighbors(); }
  /// Contacts of laws without springs.
  const HardContacts<D>& hard_contacts() const { return hard_contacts_; }
  const Ledger& ledger() const { return ledger_.entries(); }
  double time() const { return clock_.time(); }
  std::int64_t steps() const { return clock_.steps(); }
  double time_step() const { return clock_.time_step(); }
  std::int64_t max_divided_iterations() const {
    return max_divided_solves * model_.settings.max_impulse_iterations;
  }
  std::int64_t divided_steps() const { return clock_.divided_steps(); }
  const Bonds<D>& bonds() const { return model_.blocks.bonds(); }
  double bond_strain_energy() const { return load_stage_.bond_strain(); }
  double bolt_strain_energy() const { return load_stage_.bolt_strain(); }
  const Meshes<D>& meshes() const { return model_.blocks.meshes(); }
  /// After StepResult::inverted.
  const InvertedCell& inverted_cell() const { return integrator_.inverted(); }
  /// After StepResult::too_fast.
  const FastPair& fast_pair() const { return continuous_collision_.pair(); }
  std::int64_t sleeping_count() const { return sleep_.count(); }
  /// Maximum displacement error by sleep so far, over all blocks, m.
  double max_sleep_error() const { return sleep_.max_error(clock_.time()); }
  double max_penetration_ratio() const { return penetration_bound_.deepest(); }
  /// The sum of the forces on a node of a mesh at the end of the last motion.
  Vector<D> force_on_node(std::size_t node) const { return integrator_.force_on_node(node); }
  double peak_overlap() const { return contacts_.peak_overlap(); }
  /// Maximum speed so far of the free blocks, at the ends of all motions, m/s.
  double peak_speed() const { return peak_speed_; }
  /// Current maxima, over all contacts and over all free blocks.
  double largest_overlap() const;
  double largest_speed() const;
  double potential_length() const { return model_.potential_length(); }
  /// Since the last step or preparation.
  bool is_changed() const { return edited_ != 0; }
  bool knows_potential() const { return model_.materials.laws().knows_potential(); }
  /// The stable time step for the current contacts, s.
  double stable_time_step() { return stable_step_.bound(); }
  /// The block that determines it, and the other block of its stiffest contact or bond.
  typename StableStep<D>::Limit stable_limit() { return stable_step_.limit(); }
  std::optional<typename StableStep<D>::Neighbor> stiffest_neighbor_of(std::int32_t slot) const {
    return stable_step_.stiffest_neighbor_of(slot);
  }
  const Model<D>& model() const { return model_; }
  const ContactList<D>& contacts() const { return contacts_; }

  /// Steps report their passes to the stopwatch; a null pointer removes it.
  void set_stopwatch(Stopwatch* stopwatch) { stopwatch_ = stopwatch; }

  /// Finds what snapshots do not contain. Precondition: the state that was read is consistent.
  void end_reading();
  /// Validates the state read from a snapshot, so that a damaged one is refused.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(model_, contacts_, forces_, integrator_, ledger_, clock_, penetration_bound_, peak_speed_,
            load_stage_, strength_factor_, hard_contacts_, sleep_, edited_, share_);
  }

 private:
  Memory* own_memory() { return model_.blocks.kind.get_allocator().resource(); }
  void edit();
  void note_added(std::int32_t slot);
  PartOverlap overlap_of_parts(std::int32_t compound) const;
  void change_laws();
  MeshFaultReport add_surface(std::int32_t body, std::span<const SurfaceSimplex<D>> simplices,
                              std::span<const std::int32_t> cell_materials);
  void release(std::int32_t body, const Array<std::uint8_t>& is_gone, std::span<Vector<D>> released) const;
  void weigh_surface(std::int32_t body, Array<int>& bearing);
  void make_bonds();
  template <class Make>
  std::int64_t make_bonds_of(const BondLaw& law, Make make);
  /// Reserves the working memory of laws and times of impact.
  void fit_rooms();
  void renew_neighbors(int renewals = 0);
  void renew_neighbors_if_needed();
  bool bond_pair(std::int32_t a, std::int32_t b, std::int32_t law);
  /// Calls `visit(a, b)` for all blocks in touch or connected by a bolt.
  template <class Visit>
  void for_each_touch(Visit visit) const {
    for (std::size_t c = 0; c < contacts_.count(); ++c) visit(contacts_.pair_of(c).a, contacts_.pair_of(c).b);
    for (const RigidContact<D>& contact : hard_contacts_.rigid().all()) visit(contact.a, contact.b);
    for (const Bolt<D>& bolt : model_.bolts.all()) {
      if (bolt.a >= 0 && bolt.b >= 0 && !bolt.is_ruptured) visit(bolt.a, bolt.b);
    }
  }
  void wake_touched(double time) {
    wake(sleep_.wake_touched([&](auto visit) { for_each_touch(visit); }, time));
  }
  void wake(bool has_woken) {
    if (has_woken) contact_stage_.forget_sleeping();
  }
  void look_for_sleep();
  void stop_all();
  bool leaves_room_for_damping(double time_step);
  template <class RestMonitor>
  void relax_under_damping(const Relaxation& relaxation, RestMonitor& monitor, Relaxed& relaxed);
  void evaluate_forces(double elapsed, double made);
  bool choose_time_step();
  void note_speeds(const EnergySample& sample);
  /// State that a step after an edit writes before it moves the blocks, except the pairs and derived data.
  auto state() {
    return std::tuple_cat(contacts_.state(), forces_.state(), ledger_.state(), clock_.epoch(),
                          model_.blocks.bonds().state(), model_.blocks.meshes().state(), model_.bolts.state(),
                          load_stage_.state(), std::tie(peak_speed_, edited_));
  }
  bool predict_motion(double duration);
  void predict_actions(double duration);
  bool wake_met(double duration);
  void drop_plan();
  SharedMotion predict_in_share();
  StepResult prepare_and_predict();
  StepResult predict_changed();
  StepResult predict_rest();
  StepResult predict_next();
  void drop_motion();
  StepResult divide();
  /// A block that only rotates fast may have no pair.
  bool names_fast_pair() const { return continuous_collision_.any() && fast_pair().a != fast_pair().b; }
  bool is_overworked() const {
    return motions_ >= max_motions ||
           hard_contacts_.iterations() - first_iteration_ > max_divided_iterations();
  }
  StepResult diverged() const;
  StepResult load_changed();
  void move();
  void end_motion();
  AssemblyFault::Kind read_record(World& from, const PackedBlock& block, std::int32_t known,
                                  BlockRecord<D>& out);
  AssemblyFault take_blocks(World& from, std::span<const PackedBlock> blocks, CarriedPairs<D>& pairs);
  void take_pairs(const World& from, const CarriedPairs<D>& pairs);
  void take_contacts(const World& from, const CarriedPairs<D>& pairs);
  void take_settings(World& from, std::span<const PackedBlock> blocks);
  Peaks peaks() const { return {peak_speed_, contacts_.peak_overlap(), penetration_bound_.noted()}; }
  void note_peaks(const Peaks& peaks);
  void take_actions(const World& from);
  void load_everywhere();
  StepResult division_in_share();
  void lap(Pass pass) {
    if (stopwatch_ && (pass != Pass::hard_contacts || hard_contacts_.is_used())) stopwatch_->lap(pass);
  }

  Threads* threads_;
  Interrupt* interrupt_;
  Stopwatch* stopwatch_ = nullptr;
  Model<D> model_;
  EnergyLedger ledger_;
  Clock clock_;
  ContactList<D> contacts_;
  ForcePass<D> forces_;
  Share share_;
  Sleep<D> sleep_;
  Integrator<D> integrator_;
  HardContacts<D> hard_contacts_;
  StableStep<D> stable_step_;
  PenetrationBound<D> penetration_bound_;
  ContinuousCollision<D> continuous_collision_;
  ContactStage<D> contact_stage_;
  LoadStage<D> load_stage_;
  double peak_speed_ = 0;
  double strength_factor_ = 1;
  int motions_ = 0;                   // that the present step has made
  std::int64_t first_iteration_ = 0;  // of the present step
  std::int32_t edited_ = 1;           // 1: forces, accelerations and ledger are out of date
};

extern template class World<2>;
extern template class World<3>;

}  // namespace halfspace
