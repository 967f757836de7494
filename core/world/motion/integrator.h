#pragma once

#include <cmath>
#include <tuple>

#include "world/contacts/force_pass.h"
#include "world/contacts/neighbor_list.h"
#include "world/ledger.h"
#include "world/model/model.h"
#include "world/motion/mesh_motion.h"
#include "world/motion/sleep.h"

namespace halfspace {

/// No block turns farther at once, in rad, and no affine one changes its gradient more.
constexpr double max_turn = 1;

/// Velocity Verlet: plans a motion from the last forces, makes its first half up to new places and, when
/// forces are known there, its second.
template <int D>
class Integrator {
 public:
  Integrator(Model<D>& model, NeighborList<D>& neighbors, const ForcePass<D>& forces, const Sleep<D>& sleep,
             Threads* threads, Memory* memory)
      : kicks_(model.blocks, memory),
        reaction_(model.blocks, memory),
        meshes_(model, forces, kicks_, reaction_, memory),
        settings_(model.settings),
        model_(model),
        blocks_(model.blocks),
        neighbors_(neighbors),
        forces_(forces),
        sleep_(sleep),
        threads_(threads),
        acceleration_(memory),
        momentum_rate_(memory),
        next_rotation_(memory),
        any_moves_(memory),
        planned_(memory),
        samples_(memory) {}

  /// Accelerations of all blocks from the forces at hand, and what there is of energy. The noise is how much
  /// of it the blocks' fall by their own size, and positions that are off by rounding, amount to.
  EnergySample begin(double time_step, double& noise);
  /// Works out the acceleration of a block from the forces at hand.
  void accelerate(std::size_t block);

  /// Plans a motion and announces it to the neighbour list. All memory is taken here. False when it is not
  /// finite, presses a block flat or turns a cell of a mesh inside out: out of hand.
  bool predict(double duration);
  /// The cell that the last plan would have turned inside out, if any.
  const InvertedCell& inverted() const { return meshes_.inverted(); }
  double duration() const { return duration_; }
  /// The longest way of any block's points in the planned motion, and the largest turn.
  double longest_motion() const { return longest_motion_; }
  double max_rotation() const { return max_rotation_; }
  /// The planned motion of a block.
  Vector<D> predicted_displacement(std::size_t block) const;
  Tensor<D> predicted_stretch(std::size_t block) const;
  Angular<D> predicted_turn(std::size_t block) const;
  const Rotation<D>& predicted_rotation(std::size_t block) const { return next_rotation_[block]; }
  Vector<D> predicted_displacement_of_node(std::size_t node) const {
    return meshes_.predicted_displacement_of_node(node);
  }
  /// The motion of a rigid block half a step on, without the impulses of contacts.
  BlockMotion<D> motion_at_half_step(std::size_t block) const {
    const double half = 0.5 * duration_;
    return {blocks_.velocity[block] + half * acceleration_[block],
            blocks_.inertia[block].spin(blocks_.momentum[block] + half * momentum_rate_[block],
                                        blocks_.rotation[block])};
  }
  /// The mean velocity of a point in the planned motion.
  Vector<D> predicted_velocity(const MaterialPoint<D>& point) const;
  /// The acceleration of a point by the last forces.
  Vector<D> acceleration_of(const MaterialPoint<D>& point) const;

  /// The pace of the farthest point of a block, rigid or affine, by its velocity and the last forces.
  SpeedBound speed_bound_of(std::size_t block) const;

  /// Changes of velocity that the first half of a motion makes besides: a plan that has been made without
  /// them has to be made anew.
  VelocityChange<D>& kicks() { return kicks_; }
  const VelocityChange<D>& kicks() const { return kicks_; }
  void forget_reaction() { reaction_.end(); }
  /// A force and a torque on a block.
  struct BlockLoad {
    Vector<D> force;
    Angular<D> torque;
  };
  /// Those that the kick at the end of the last motion stands for.
  BlockLoad reaction(std::size_t block) const;
  Tensor<D> strain_reaction(std::size_t block) const;
  Vector<D> reaction_on_node(std::size_t node) const { return meshes_.reaction(node); }

  /// Velocities to the middle of the planned motion, places to its end.
  void kick_and_drift();
  /// Moves a rigid block by a displacement and a turn, given as a motion over one second.
  void displace(std::size_t block, const BlockMotion<D>& by) {
    const double angle = D == 2 ? blocks_.angle[block] + by.spin[0] : 0;
    blocks_.place(std::int32_t(block), blocks_.position[block] + by.velocity,
                  blocks_.rotation[block].turned_by(by.spin));
    if constexpr (D == 2) blocks_.angle[block] = angle;
  }
  /// Velocities to its end.
  EnergySample kick();
  /// Takes the kicks into the velocities at the end of the motion, and the stock anew.
  void take_kicks(EnergySample& sample);

  void reserve(std::size_t slots) {
    acceleration_.reserve(slots);
    momentum_rate_.reserve(slots);
    any_moves_.reserve(chunk_count(slots, blocks_per_chunk));
    meshes_.reserve();
  }
  /// Memory has been reserved.
  void resize(std::size_t slots) {
    acceleration_.resize(slots, Vector<D>::Zero());
    momentum_rate_.resize(slots, Angular<D>::Zero());
    meshes_.resize();
  }

  /// The accelerations of all that moves freely.
  auto state() {
    return std::tuple_cat(std::tie(acceleration_, momentum_rate_, blocks_.deformations().all()),
                          meshes_.state());
  }

  /// False for what cannot be, after reading a snapshot.
  bool is_consistent(bool is_edited) const {
    const std::size_t slots = blocks_.slot_count();
    if (!is_edited && (acceleration_.size() != slots || momentum_rate_.size() != slots)) return false;
    if (!meshes_.is_consistent(is_edited) || !reaction_.is_consistent()) return false;
    return acceleration_.size() <= slots && momentum_rate_.size() <= slots;
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(acceleration_, momentum_rate_, reaction_, meshes_);
    if constexpr (Archive::reads) look_what_moves();
  }

 private:
  /// Blocks that one worker goes through at once.
  static constexpr std::size_t blocks_per_chunk = 256;

  /// The plan of a chunk of blocks.
  struct Plan {
    bool is_valid = true;
    bool needs_rebuild = false;
    bool goes_far = false;  // some block by more than its radius
    double longest_motion = 0;
    double max_rotation = 0;
  };

  /// Blocks that stand cost nothing where there is a row of them.
  void look_what_moves();
  template <class Sums, class Visit>
  void sum_each_block(Sums& sums, Visit visit);
  /// Those that drive a block, before damping.
  BlockLoad load_on(std::size_t block) const;
  void take_kick(std::size_t block, EnergySample& sample);
  void accelerate_rigid(std::size_t block);
  bool predict_block(std::size_t block, const Vector<D>& velocity, double turn, Plan& plan);
  bool predict_motion_of(std::size_t block, Plan& plan);
  void announce_displacements();
  void kick(std::size_t block, EnergySample& sample);
  void kick_asleep(std::size_t block, EnergySample& sample) const;
  void sample_energy(std::size_t block, const Vector<D>& opposed, const Angular<D>& opposed_spin,
                     EnergySample& sample) const;

  // The same for affine blocks is in integrator_affine.cpp.
  Vector<D> affine_load(std::size_t block) const;
  Tensor<D> generalized_force(std::size_t block) const;
  void accelerate_affine(std::size_t block);
  bool predict_affine(std::size_t block, Plan& plan);
  void kick_and_drift_affine(std::size_t block);
  void sample_affine_energy(std::size_t block, const Vector<D>& opposed, const Tensor<D>& opposed_rate,
                            EnergySample& sample) const;
  void kick_affine(std::size_t block, EnergySample& sample);
  void take_affine_kick(std::size_t block, EnergySample& sample);

  VelocityChange<D> kicks_;
  VelocityChange<D> reaction_;  // those at the end of the last motion
  MeshMotion<D> meshes_;
  const WorldSettings<D>& settings_;
  const Model<D>& model_;
  Blocks<D>& blocks_;
  NeighborList<D>& neighbors_;
  const ForcePass<D>& forces_;
  const Sleep<D>& sleep_;
  Threads* threads_;
  Array<Vector<D>> acceleration_;     // of each block, from the last forces
  Array<Angular<D>> momentum_rate_;   // of the angular momentum, likewise
  Array<Rotation<D>> next_rotation_;  // planned
  Array<std::uint8_t> any_moves_;     // in each chunk of blocks; worked out when the world has been changed
  Array<Plan> planned_;               // of each chunk of blocks
  Array<EnergySample> samples_;       // likewise
  double duration_ = 0;               // of the planned motion: the step or a part of it
  double longest_motion_ = 0;
  double max_rotation_ = 0;
};

extern template class Integrator<2>;
extern template class Integrator<3>;

}  // namespace halfspace
