#pragma once

#include <cmath>
#include <tuple>
#include <utility>

#include "world/contacts/force_pass.h"
#include "world/contacts/neighbor_list.h"
#include "world/model/model.h"
#include "world/model/share.h"
#include "world/motion/ledger.h"
#include "world/motion/mesh_motion.h"
#include "world/motion/sleep.h"

namespace halfspace {

/// Maximum rotation of a block per motion, rad; also the maximum change of an affine block's gradient.
constexpr double max_turn = 1;

/// Blocks that a worker processes at a time.
constexpr std::size_t blocks_per_chunk = 256;

/// Velocity Verlet: predicts a motion from the last forces, makes its first half (kick and drift), and its
/// second (kick) when the forces at the new positions are known.
template <int D>
class Integrator {
 public:
  Integrator(Model<D>& model, NeighborList<D>& neighbors, const ForcePass<D>& forces, const Sleep<D>& sleep,
             const Share& share, Threads* threads, Memory* memory)
      : kicks_(model.blocks, memory),
        reaction_(model.blocks, memory),
        meshes_(model, forces, kicks_, reaction_, threads, memory),
        settings_(model.settings),
        model_(model),
        blocks_(model.blocks),
        neighbors_(neighbors),
        forces_(forces),
        sleep_(sleep),
        share_(share),
        threads_(threads),
        acceleration_(memory),
        momentum_rate_(memory),
        next_rotation_(memory),
        any_moves_(memory),
        predictions_(memory),
        samples_(memory) {}

  /// Computes the accelerations of all blocks from the last forces, and returns their energies. `noise`: the
  /// energy of a fall of the blocks by their own size, plus that of rounding errors of positions.
  EnergySample begin(double time_step, double& noise);
  /// Computes the acceleration of a block from the last forces.
  void accelerate(std::size_t block);

  /// Predicts a motion, announces it to the neighbour list, and allocates its memory. False when it is not
  /// finite, flattens a block or inverts a mesh cell.
  bool predict(double duration);
  /// Takes over the loads and velocities that actions give for the coming motion.
  void take_actions(double duration);
  /// The change of the outer power by velocities that jump at the begin of the predicted motion.
  double power_of_jumps() const;
  /// The cell that the last predicted motion would invert, if any.
  const InvertedCell& inverted() const { return meshes_.inverted(); }
  double duration() const { return duration_; }
  /// The maximum displacement of any point, and the maximum rotation, in the predicted motion.
  double longest_motion() const { return longest_motion_; }
  double max_rotation() const { return max_rotation_; }
  /// The predicted motion of a block.
  Vector<D> predicted_displacement(std::size_t block) const;
  Tensor<D> predicted_stretch(std::size_t block) const;
  Angular<D> predicted_turn(std::size_t block) const;
  const Rotation<D>& predicted_rotation(std::size_t block) const { return next_rotation_[block]; }
  Vector<D> predicted_displacement_of_node(std::size_t node) const {
    return meshes_.predicted_displacement_of_node(node);
  }
  /// The motion of a rigid or prescribed block half a step on, without the impulses of contacts.
  BlockMotion<D> motion_at_half_step(std::size_t block) const {
    const double half = 0.5 * duration_;
    if (blocks_.kind[block] == BlockKind::prescribed) {
      return {blocks_.velocity[block] + half * acceleration_[block],
              blocks_.spin[block] + half * momentum_rate_[block]};
    }
    return {blocks_.velocity[block] + half * acceleration_[block],
            blocks_.inertia[block].spin(blocks_.momentum[block] + half * momentum_rate_[block],
                                        blocks_.rotation[block])};
  }
  /// Its motion in the middle of the motion, when the second half of the kick has been made.
  BlockMotion<D> motion_half_a_step_ago(std::size_t block) const {
    const double half = 0.5 * duration_;
    const Vector<D> velocity = blocks_.velocity[block] - half * acceleration_[block];
    if (blocks_.kind[block] == BlockKind::prescribed)
      return {velocity, blocks_.spin[block] - half * momentum_rate_[block]};
    return {velocity, blocks_.inertia[block].spin(blocks_.momentum[block] - half * momentum_rate_[block],
                                                  blocks_.rotation[block])};
  }
  /// The mean velocity of a point in the predicted motion.
  Vector<D> predicted_velocity(const MaterialPoint<D>& point) const;
  /// The acceleration of a point by the last forces.
  Vector<D> acceleration_of(const MaterialPoint<D>& point) const;

  /// Bounds of the points of a rigid or affine block, or of all parts of a compound, from its velocity and
  /// the last forces.
  SpeedBound speed_bound_of(std::size_t block) const;
  /// The same, with the impulses of the last motion as forces.
  SpeedBound speed_bound_with_impulses_of(std::size_t block) const;
  bool is_asleep(std::size_t block) const { return sleep_.is_asleep(block); }
  const Sleep<D>& sleep() const { return sleep_; }

  /// Velocity changes by contact impulses. Repeat predict() when those of the first half change.
  VelocityChange<D>& kicks() { return kicks_; }
  const VelocityChange<D>& kicks() const { return kicks_; }
  void forget_reaction() { reaction_.end(); }
  /// Changes the velocity of a rigid block to none at the middle or the end of the predicted motion.
  void hold(std::size_t block, bool at_middle) {
    const double half = at_middle ? 0.5 * duration_ : 0;
    kicks_.set(block, -(blocks_.velocity[block] + half * acceleration_[block]),
               -(blocks_.momentum[block] + half * momentum_rate_[block]));
  }
  /// Does a block stand, and would the reaction at the end of the last motion, of the same duration, hold it
  /// under its present rates?
  bool is_held(std::size_t block, double duration) const {
    const double half = 0.5 * duration;
    return blocks_.velocity[block].isZero(0) && blocks_.momentum[block].isZero(0) &&
           reaction_.of_block(block) == -half * acceleration_[block] &&
           reaction_.momentum(block) == -half * momentum_rate_[block];
  }
  /// Changes the velocity of a block as the reaction did at the end of the last motion.
  void hold_again(std::size_t block) { kicks_.take_over(block, reaction_); }
  /// A force and a torque on a block.
  struct BlockLoad {
    Vector<D> force;
    Angular<D> torque;
  };
  /// The constraint forces equivalent to the impulses at the end of the last motion.
  BlockLoad reaction(std::size_t block) const {
    if (reaction_.empty()) return {Vector<D>::Zero(), Angular<D>::Zero()};
    const double rate = reaction_.rate();
    return {rate * blocks_.mass[block] * reaction_.of_block(block), rate * reaction_.momentum(block)};
  }
  Tensor<D> strain_reaction(std::size_t block) const;
  Vector<D> reaction_on_node(std::size_t node) const { return meshes_.reaction(node); }
  Vector<D> load_of_actions_on_node(std::size_t node) const { return meshes_.load_of_actions(node); }
  /// The sum of the forces on a node of a mesh, before damping.
  Vector<D> force_on_node(std::size_t node) const { return meshes_.force_on(node); }

  /// Advances velocities to the middle of the predicted motion, and positions to its end.
  void kick_and_drift();
  /// Moves a rigid block by a displacement and a turn, given as a motion over one second.
  void displace(std::size_t block, const BlockMotion<D>& by) {
    const double angle = D == 2 ? blocks_.angle[block] + by.spin[0] : 0;
    blocks_.place(std::int32_t(block), blocks_.position[block] + by.velocity,
                  blocks_.rotation[block].turned_by(by.spin));
    if constexpr (D == 2) blocks_.angle[block] = angle;
  }
  /// Advances velocities to its end.
  EnergySample kick();
  /// Adds the velocity changes of contacts to the velocities at the end, and samples the energy again.
  void take_kicks(EnergySample& sample);

  void reserve(std::size_t slots) {
    acceleration_.reserve(slots);
    momentum_rate_.reserve(slots);
    any_moves_.reserve(chunk_count(slots, blocks_per_chunk));
    meshes_.reserve();
  }
  /// Allocates nothing after reserve().
  void resize(std::size_t slots) {
    acceleration_.resize(slots, Vector<D>::Zero());
    momentum_rate_.resize(slots, Angular<D>::Zero());
    meshes_.resize();
  }

  /// A block's acceleration and the rate of its angular momentum, from the last forces.
  std::pair<Vector<D>, Angular<D>> rates_of(std::size_t block) const {
    if (block >= acceleration_.size()) return {Vector<D>::Zero(), Angular<D>::Zero()};
    return {acceleration_[block], momentum_rate_[block]};
  }
  void set_rates(std::size_t block, const std::pair<Vector<D>, Angular<D>>& rates) {
    std::tie(acceleration_[block], momentum_rate_[block]) = rates;
  }
  /// Marks the chunks in which any block moves; the others cost nothing.
  void look_what_moves();

  /// The accelerations of all free blocks and nodes.
  auto state() {
    return std::tuple_cat(std::tie(acceleration_, momentum_rate_, blocks_.deformations().all()),
                          meshes_.state());
  }

  /// Validates the state read from a snapshot.
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
  /// The predicted motion of a chunk of blocks.
  struct Prediction {
    bool is_valid = true;
    bool needs_rebuild = false;
    bool goes_far = false;  // some block moves by more than its radius
    double longest_motion = 0;
    double max_rotation = 0;
  };

  template <class Sums, class Visit>
  void sum_each_block(Sums& sums, Visit visit) {
    sum_each_chunk(threads_, blocks_.slot_count(), blocks_per_chunk, sums,
                   [&](const Chunk& chunk, auto& sum) {
                     if (!any_moves_[chunk.index]) return;
                     for (std::size_t i = chunk.begin; i < chunk.end; ++i) visit(i, sum);
                   });
  }
  /// The load on a block, before damping.
  BlockLoad load_on(std::size_t block) const {
    BlockLoad load{
        blocks_.force[block] + blocks_.applied_force[block] + blocks_.mass[block] * settings_.gravity,
        blocks_.torque[block] + blocks_.applied_torque[block]};
    if (model_.actions.empty()) return load;
    load.force += blocks_.mass[block] * model_.actions.acceleration();
    if (const auto* target = model_.actions.target_of(block)) {
      load.force += target->force;
      load.torque += target->torque;
    }
    return load;
  }
  void take_kick(std::size_t block, EnergySample& sample);
  [[gnu::always_inline]] inline void accelerate_rigid(std::size_t block);
  bool predict_block(std::size_t block, const Vector<D>& velocity, double turn, Prediction& prediction);
  bool predict_motion_of(std::size_t block, Prediction& prediction);
  bool predict_parts(Prediction& prediction);
  Vector<D> predicted_displacement_of_part(std::size_t block) const;
  void announce_displacements();
  void follow_motion(const Part<D>& part);
  void follow_velocities();
  void kick(std::size_t block, EnergySample& sample);
  void kick_asleep(std::size_t block, EnergySample& sample) const;
  [[gnu::always_inline]] inline void sample_energy(std::size_t block, const Vector<D>& opposed,
                                                   const Angular<D>& opposed_spin,
                                                   EnergySample& sample) const;

  // For affine blocks, in integrator_affine.cpp.
  Vector<D> affine_load(std::size_t block) const;
  Tensor<D> generalized_force(std::size_t block) const;
  void accelerate_affine(std::size_t block);
  bool predict_affine(std::size_t block, Prediction& prediction);
  void kick_and_drift_affine(std::size_t block);
  void sample_affine_energy(std::size_t block, const Vector<D>& opposed, const Tensor<D>& opposed_rate,
                            EnergySample& sample) const;
  void kick_affine(std::size_t block, EnergySample& sample);
  void take_affine_kick(std::size_t block, EnergySample& sample);

  // In integrator_actions.cpp.
  double power_of_actions(std::size_t block, const Vector<D>& velocity, const Angular<D>& spin) const;
  /// Gives a block the velocity of its actions at the end of the motion.
  void give_velocity(std::size_t block, EnergySample& sample);
  double support_power(std::size_t block, const Vector<D>& opposed) const;

  VelocityChange<D> kicks_;
  VelocityChange<D> reaction_;  // by impulses at the end of the last motion
  MeshMotion<D> meshes_;
  const WorldSettings<D>& settings_;
  const Model<D>& model_;
  Blocks<D>& blocks_;
  NeighborList<D>& neighbors_;
  const ForcePass<D>& forces_;
  const Sleep<D>& sleep_;
  const Share& share_;
  Threads* threads_;
  // From the last forces; of prescribed blocks those of their actions, also instead of the momentum's rate.
  Array<Vector<D>> acceleration_;
  Array<Angular<D>> momentum_rate_;   // of the angular momentum
  Array<Rotation<D>> next_rotation_;  // predicted
  Array<std::uint8_t> any_moves_;     // per chunk of blocks; updated after an edit
  Array<Prediction> predictions_;     // per chunk of blocks
  Array<EnergySample> samples_;       // likewise
  double duration_ = 0;               // of the predicted motion: a step or a part of it, s
  double longest_motion_ = 0;
  double max_rotation_ = 0;
};

extern template class Integrator<2>;
extern template class Integrator<3>;

}  // namespace halfspace
