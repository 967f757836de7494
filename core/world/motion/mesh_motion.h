#pragma once

#include <tuple>

#include "block/mesh/meshes.h"
#include "world/contacts/force_pass.h"
#include "world/model/model.h"
#include "world/motion/element_pass.h"
#include "world/motion/ledger.h"
#include "world/motion/velocity_change.h"

namespace halfspace {

/// The integration of meshes. Elements, gravity and the contacts of surface blocks load the nodes; surface
/// blocks follow their nodes.
template <int D>
class MeshMotion {
 public:
  MeshMotion(Model<D>& model, const ForcePass<D>& forces, const VelocityChange<D>& kicks,
             const VelocityChange<D>& reaction, Threads* threads, Memory* memory)
      : settings_(model.settings),
        model_(model),
        meshes_(model.blocks.meshes()),
        elements_(model, threads, memory),
        threads_(threads),
        forces_(forces),
        kicks_(kicks),
        reaction_(reaction),
        acceleration_(memory),
        surface_loads_(memory),
        samples_(memory) {}

  /// Computes the forces and accelerations of all nodes. Adds to the energies, and to the noise of
  /// Integrator::begin().
  void begin(double time_step, EnergySample& sample, double& noise);
  /// False when the motion is not finite or would invert a cell, which inverted() then returns.
  bool predict(double duration);
  const InvertedCell& inverted() const { return inverted_; }
  /// The predicted motion of a surface block.
  Vector<D> predicted_displacement(std::size_t block) const;
  Tensor<D> predicted_stretch(std::size_t block) const;
  /// The constraint force equivalent to the impulses at the end of the last motion.
  Vector<D> reaction(std::size_t node) const {
    if (reaction_.empty()) return Vector<D>::Zero();
    return reaction_.rate() * meshes_.mass[node] * reaction_.of_node(node);
  }
  Vector<D> predicted_displacement_of_node(std::size_t node) const {
    Vector<D> velocity = meshes_.velocity[node] + 0.5 * duration_ * acceleration_[node];
    if (!kicks_.empty()) velocity += kicks_.of_node(node);
    return duration_ * velocity;
  }
  const Vector<D>& acceleration_of(std::size_t node) const { return acceleration_[node]; }
  /// Takes over the loads and velocities that actions give for the coming motion.
  void take_actions(double duration);
  Vector<D> load_of_actions(std::size_t node) const {
    return model_.actions.load_on_node(node) + meshes_.mass[node] * model_.actions.acceleration();
  }
  /// The change of the power of supports by jumps of their velocities at the begin of the motion.
  double power_of_jumps() const;
  /// The sum of the forces on a node, before damping.
  Vector<D> force_on(std::size_t node) const {
    return model_.actions.empty() ? meshes_.force[node] : meshes_.force[node] + load_of_actions(node);
  }
  /// Advances velocities to the middle of the motion, and positions to its end.
  void kick_and_drift(double duration);
  /// Advances velocities to its end.
  void kick(double duration, EnergySample& sample);
  /// Adds the velocity changes of contacts, and samples the energy again.
  void take_kicks(double duration, EnergySample& sample);

  void reserve() {
    acceleration_.reserve(meshes_.node_count());
    surface_loads_.reserve(meshes_.surface().size());
    samples_.reserve(chunk_count(meshes_.node_count(), nodes_per_chunk));
    elements_.fit_room();
  }
  /// Allocates nothing after reserve().
  void resize() { acceleration_.resize(meshes_.node_count(), Vector<D>::Zero()); }

  /// Accelerations and the maximum strain, by the last forces.
  auto state() { return std::tie(acceleration_, largest_strain_); }

  /// Validates the state read from a snapshot.
  bool is_consistent(bool is_edited) const {
    return is_edited || acceleration_.size() == meshes_.node_count();
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(acceleration_, largest_strain_);
  }

 private:
  using CornerLoads = Eigen::Matrix<double, D, D + 1>;

  template <class Visit>
  void for_each_node(Visit visit) {
    for_each_chunk(threads_, meshes_.node_count(), nodes_per_chunk, [&](const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) visit(i);
    });
  }
  template <class Visit>
  void for_each_surface_cell(Visit visit) {
    for_each_chunk(threads_, meshes_.surface().size(), cells_per_chunk, [&](const Chunk& chunk) {
      for (std::size_t c = chunk.begin; c < chunk.end; ++c) visit(c);
    });
  }
  /// Calls visit(node, body, sum) for all nodes, and adds the sums of their chunks to `sample`.
  template <class Visit>
  void sum_each_node(EnergySample& sample, Visit visit) {
    for (const Body<D>& body : meshes_.bodies()) {
      sum_each_chunk(threads_, std::size_t(body.node_count), nodes_per_chunk, samples_,
                     [&](const Chunk& chunk, EnergySample& sum) {
                       const std::size_t first = std::size_t(body.first_node);
                       for (std::size_t i = chunk.begin; i < chunk.end; ++i) visit(first + i, body, sum);
                     });
      for (const EnergySample& sum : samples_) sample.add(sum);
    }
  }
  bool is_held(std::size_t node, int component) const { return (meshes_.held[node] >> component & 1) != 0; }
  double evaluate_forces();
  void load_nodes_at_surface();
  CornerLoads load_of(const SurfaceCell<D>& cell) const;
  /// `to_end`: time from the node's present velocity to the end of the motion; 0 for its first half.
  void accelerate(std::size_t node, double to_end);
  void damp_by_ground(std::size_t node, double to_end);
  double power_of_ground(std::size_t node, const Tensor<D>& viscosity) const;
  void give_velocities(EnergySample& sample);
  /// Bounds of the change of any element's gradient in the predicted motion, by displacements and by rounding
  /// of positions.
  struct Bending {
    double by_motion = 0;
    double by_rounding = 0;
  };
  Bending max_bending() const;
  bool keeps_upright();
  void sample_energy(std::size_t node, const Vector<D>& opposed, EnergySample& sample) const;
  void take_surface_stock(EnergySample& sample) const;
  void end_kick(double duration, const VelocityChange<D>* kicks, EnergySample& sample);

  const WorldSettings<D>& settings_;
  Model<D>& model_;
  Meshes<D>& meshes_;
  ElementPass<D> elements_;
  Threads* threads_;
  const ForcePass<D>& forces_;
  const VelocityChange<D>& kicks_;
  const VelocityChange<D>& reaction_;
  Array<Vector<D>> acceleration_;     // per node, from the last forces
  Array<CornerLoads> surface_loads_;  // of all surface cells on their nodes
  Array<EnergySample> samples_;       // per chunk of nodes of a body
  double largest_strain_ = 0;         // maximum over all cells, squared, at the last forces
  double strain_energy_ = 0;          // of all elements, at the last forces
  double duration_ = 0;               // of the predicted motion
  InvertedCell inverted_;
};

extern template class MeshMotion<2>;
extern template class MeshMotion<3>;

}  // namespace halfspace
