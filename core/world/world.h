#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>

#include "block/mesh/surface.h"
#include "world/contacts/bond_pass.h"
#include "world/contacts/contact_list.h"
#include "world/contacts/entrance.h"
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
#include "world/stopwatch.h"

namespace halfspace {

enum class StepResult { ok, unstable, no_time_step, too_fast, inverted };

/// A mesh that has become a body, or what keeps it from that.
struct PlacedMesh {
  MeshFaultReport report;
  std::int32_t body = -1;
};

/// A stress that is linear in space.
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

/// The end of bringing a world to rest.
struct Relaxed {
  StepResult result = StepResult::ok;
  bool is_at_rest = false;
  bool has_failed = false;  // some block or node has moved too far
  std::int64_t steps = 0;
  Balance balance;
};

/// The most motions in one call of step().
constexpr int max_motions = 1 << 14;

/// Blocks, their contacts, and time. Holds the parts of a world and puts them in order: a step plans a
/// motion, makes its first half, finds the contacts at the new places, loads the blocks with their forces,
/// makes the second half and books the energy.
template <int D>
class World {
 public:
  /// The threads, if any, must live as long.
  World(const WorldSettings<D>& settings, Memory* memory, Threads* threads = nullptr);

  // Making and changing.
  std::int32_t add_material(double density);
  double density(std::int32_t material) const { return model_.materials.density(material); }
  std::int32_t material_count() const { return model_.materials.count(); }
  /// False when a cell of that material would be too stiff to be computed with: then nothing has changed.
  bool set_elasticity(std::int32_t material, const Elasticity& elasticity);
  const Elasticity& elasticity(std::int32_t material) const { return model_.materials.elasticity(material); }
  void set_default_law(const ContactLaw& law);
  void set_law(std::int32_t a, std::int32_t b, const ContactLaw& law);
  std::int32_t add_block(const Shape<D>& shape, BlockKind kind, std::int32_t material,
                         const Vector<D>& position, const Rotation<D>& rotation);
  void remove_block(std::int32_t slot);
  void set_pose(std::int32_t slot, const Vector<D>& position, const Rotation<D>& rotation);
  void set_velocity(std::int32_t slot, const Vector<D>& velocity, const Angular<D>& spin);
  /// Puts a mesh into the world, at a pose of its frame, with a material for each cell; and its surface's
  /// cells, as blocks. When memory runs out nothing has changed.
  PlacedMesh add_mesh(const Mesh<D>& mesh, const Pose<D>& pose, std::span<const std::int32_t> cell_materials);
  void remove_mesh(std::int32_t body);
  /// Takes cells out of a body, not all of them; what they bordered on is its surface from now on. Adds what
  /// they did to nodes, by their stress and their weight, to `released`, one for each node of the body. A
  /// node without a cell stays where it is, without mass. Nothing has changed where there is a fault, or
  /// memory runs out.
  MeshFaultReport remove_cells(std::int32_t body, std::span<const std::int32_t> cells,
                               std::span<Vector<D>> released);
  /// Stresses the cells of a body as they are now. False, and nothing has changed, for a stress beyond
  /// bounds.
  bool set_body_stress(std::int32_t body, const StressField<D>& field);
  /// Bonds two blocks along their common face, as they are now: false when they have none, or hold together
  /// already.
  bool bond_pair(std::int32_t a, std::int32_t b, const BondLaw& law);
  /// Bonds all pairs of blocks of two materials along their common faces, and tells how many.
  std::int64_t bond_materials(std::int32_t material_a, std::int32_t material_b, const BondLaw& law);
  /// Held bonds do not fail.
  void hold_bonds(bool are_held);
  /// Components of a node's velocity that are held stay as they are set; bit k of `held` stands for component
  /// k.
  void hold_node(std::size_t node, std::uint8_t held);
  void set_node_velocity(std::size_t node, const Vector<D>& velocity);
  void set_node_force(std::size_t node, const Vector<D>& force);
  /// The blocks at a body's surface take up what has been set for its nodes.
  void end_node_edits(std::int32_t body);
  /// For an affine block.
  void set_deformation(std::int32_t slot, const Tensor<D>& gradient, const Tensor<D>& rate);
  void set_stress(std::int32_t slot, const Tensor<D>& stress);
  /// Force per area of a face, in the plane of an edge, as the shape was given.
  void add_surface_load(std::int32_t slot, int face, const Vector<D>& traction);
  void clear_surface_loads(std::int32_t slot);
  void set_applied_force(std::int32_t slot, const Vector<D>& force, const Angular<D>& torque);
  /// Sets the shear spring of a contact in force on b, of which what lies in the contact plane counts. False
  /// when it has none.
  bool set_shear_force(std::size_t contact, const Vector<D>& force);

  // Stages.
  /// Neighbour search, when motion has used the list up, and detection.
  void detect();
  bool is_detected() const { return contacts_.are_found(); }
  /// Contact forces into the blocks; shear springs grow over `elapsed`.
  void evaluate_forces_for_host(double elapsed);
  /// One step of velocity Verlet. When memory runs out the world is as it was before; when the motion is not
  /// stable no block has moved.
  StepResult step();
  /// Steps under strong damping until forces are in balance. What is at rest then has no
  /// velocity; damping and bonds are as before.
  Relaxed relax(const Relaxation& relaxation);
  Balance balance();
  void set_gravity(const Vector<D>& gravity);
  void set_damping(double local_damping, double mass_damping);
  void set_time_step(double time_step);
  /// All strengths of laws and bonds are those given over this factor: friction, cohesion, tensile strength.
  void set_strength_factor(double factor);
  /// Brings time step, contacts, forces and ledger up to date after changes.
  StepResult prepare();

  // Reading.
  const Blocks<D>& blocks() const { return model_.blocks; }
  std::size_t contact_count() const { return contacts_.count(); }
  Contact<D> contact(std::size_t c) const { return contacts_.contact(c); }
  /// Forces may not have been evaluated yet.
  bool knows_forces() const { return forces_.are_known(); }
  const ContactForce<D>& contact_force(std::size_t c) const { return forces_.of_contact(c); }
  const Candidate<D>& candidate_of(std::size_t contact) const { return contacts_.pair_of(contact); }
  std::optional<std::size_t> contact_between(std::int32_t a, std::int32_t b) const {
    return contacts_.contact_between(a, b);
  }
  const NeighborList<D>& candidates() const { return contacts_.neighbors(); }
  /// Contacts by laws without a spring.
  const HardContacts<D>& hard_contacts() const { return hard_contacts_; }
  const Ledger& ledger() const { return ledger_.entries(); }
  double time() const { return clock_.time(); }
  std::int64_t steps() const { return clock_.steps(); }
  double time_step() const { return clock_.time_step(); }
  std::int64_t divided_steps() const { return clock_.divided_steps(); }
  const Bonds<D>& bonds() const { return model_.blocks.bonds(); }
  double bond_strain_energy() const { return bond_strain_energy_; }
  const Meshes<D>& meshes() const { return model_.blocks.meshes(); }
  /// After StepResult::inverted.
  const InvertedCell& inverted_cell() const { return integrator_.inverted(); }
  /// After StepResult::too_fast.
  const FastPair& fast_pair() const { return continuous_collision_.pair(); }
  std::int64_t sleeping_count() const { return sleep_.count(); }
  /// The most of its way that any block has missed by sleep.
  double max_sleep_error() const { return sleep_.max_error(clock_.time()); }
  double max_penetration_ratio() const { return penetration_bound_.deepest(); }
  double peak_overlap() const { return contacts_.peak_overlap(); }
  /// The largest of all blocks that move freely, at the ends of all motions so far.
  double peak_speed() const { return peak_speed_; }
  /// The largest at present, of all contacts and of all blocks that move freely.
  double largest_overlap() const;
  double largest_speed() const;
  double potential_length() const { return model_.potential_length(); }
  bool knows_potential() const { return model_.materials.laws().knows_potential(); }
  /// The bound for the contacts that are known.
  double stable_time_step() { return stable_step_.bound(); }
  /// The block that sets it, and what this meets or is bonded to most stiffly.
  typename StableStep<D>::Limit stable_limit() { return stable_step_.limit(); }
  std::optional<typename StableStep<D>::Neighbor> stiffest_neighbor_of(std::int32_t slot) const {
    return stable_step_.stiffest_neighbor_of(slot);
  }
  const Model<D>& model() const { return model_; }
  const ContactList<D>& contacts() const { return contacts_; }

  /// Steps tell it their passes, until it is taken away by a null pointer.
  void set_stopwatch(Stopwatch* stopwatch) { stopwatch_ = stopwatch; }

  /// Takes the room that laws and times of impact need, which a snapshot does not hold.
  void fit_rooms();
  /// False for what no world can be, after reading a snapshot: a damaged one is refused and not run.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(model_, contacts_, forces_, integrator_, ledger_, clock_, penetration_bound_, peak_speed_,
            bond_strain_energy_, strength_factor_, hard_contacts_, sleep_, edited_);
  }

 private:
  void edit();
  void change_laws();
  MeshFaultReport add_surface(std::int32_t body, std::span<const SurfaceSimplex<D>> simplices,
                              std::span<const std::int32_t> cell_materials);
  void release(std::int32_t body, const Array<std::uint8_t>& is_gone, std::span<Vector<D>> released) const;
  void weigh_surface(std::int32_t body, Array<int>& bearing);
  void make_bonds();
  template <class Make>
  std::int64_t make_bonds_of(const BondLaw& law, Make make);
  void forget_contacts();
  void renew_neighbors(double skin_factor = 1);
  void renew_neighbors_if_needed();
  template <class OnContact>
  void find_in(const Chunk& pairs, PairSums& sums, OnContact on_contact);
  template <class Visit>
  void pass_over_pairs(Visit visit);
  template <class OnContact>
  void take_in_met(OnContact on_contact);
  void end_finding();
  bool bond_pair(std::int32_t a, std::int32_t b, std::int32_t law);
  void load_by_bonds(double elapsed);
  void load_left_out();
  void wake(bool has_woken) { are_left_out_loaded_ = are_left_out_loaded_ && !has_woken; }
  void look_for_sleep();
  void stop_all();
  bool leaves_room_for_damping(double time_step);
  template <class RestMonitor>
  void relax_under_damping(const Relaxation& relaxation, RestMonitor& monitor, Relaxed& relaxed);
  void evaluate_forces(double elapsed);
  bool choose_time_step();
  void note_speeds(const EnergySample& sample);
  /// All that a step of a changed world writes to before it moves the blocks, but for the pairs and what is
  /// worked out anew from the rest.
  auto state() {
    return std::tuple_cat(contacts_.state(), forces_.state(), ledger_.state(), clock_.epoch(),
                          model_.blocks.bonds().state(), model_.blocks.meshes().state(),
                          std::tie(peak_speed_, bond_strain_energy_, edited_));
  }
  bool predict_motion(double duration);
  StepResult prepare_and_predict();
  StepResult predict_changed();
  StepResult predict_rest();
  StepResult divide();
  StepResult diverged() const;
  void move();
  void lap(Pass pass) {
    if (stopwatch_ && (pass != Pass::hard_contacts || hard_contacts_.is_used())) stopwatch_->lap(pass);
  }

  Threads* threads_;
  Stopwatch* stopwatch_ = nullptr;
  Model<D> model_;
  EnergyLedger ledger_;
  Clock clock_;
  ContactList<D> contacts_;
  ForcePass<D> forces_;
  BondPass<D> bond_pass_;
  Sleep<D> sleep_;
  Integrator<D> integrator_;
  HardContacts<D> hard_contacts_;
  StableStep<D> stable_step_;
  PenetrationBound<D> penetration_bound_;
  ContinuousCollision<D> continuous_collision_;
  Entrances<D> entrances_;
  Array<PairSums> sums_;  // of each chunk of pairs
  double peak_speed_ = 0;
  double bond_strain_energy_ = 0;
  double left_out_strain_ = 0;        // in contacts that sleep leaves out
  bool are_left_out_loaded_ = false;  // their forces are at hand
  double strength_factor_ = 1;
  double made_ = 0;          // duration of the motion just made, while contacts are found that it has led to
  std::int32_t edited_ = 1;  // since the last step: forces, accelerations and ledger are of another state
};

extern template class World<2>;
extern template class World<3>;

}  // namespace halfspace
