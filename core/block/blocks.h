#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>

#include "block/block_kind.h"
#include "block/block_state.h"
#include "block/bond/bonds.h"
#include "block/compound_body.h"
#include "block/compounds.h"
#include "block/deformations.h"
#include "block/face.h"
#include "block/inertia.h"
#include "block/mesh/meshes.h"
#include "block/outlines.h"
#include "geometry/box.h"
#include "geometry/outline.h"
#include "geometry/rotation.h"
#include "geometry/shape.h"
#include "geometry/vector.h"

namespace halfspace {

/// The outlines of two blocks at their present poses, and the vector from a's centroid to b's.
template <int D>
struct PlacedBlocks {
  Outline<D> a;
  Outline<D> b;
  Vector<D> to_b;
};

/// All blocks of a world, as a structure of arrays. Slots of removed blocks are reused, with a new
/// generation.
template <int D>
class Blocks {
 public:
  explicit Blocks(Memory* memory);

  std::size_t slot_count() const { return kind.size(); }
  /// From this slot on no block moves; the one before does. So fixed blocks that are added last cost a pass
  /// over blocks nothing.
  std::size_t moving_end() const { return std::size_t(moving_end_); }
  bool lives(std::size_t slot) const { return kind[slot] != BlockKind::none; }
  /// By Newton's law.
  bool moves_freely(std::size_t slot) const { return kind[slot] >= BlockKind::rigid; }
  /// Moves by Newton's law, and neither with the nodes of a mesh nor with a compound.
  bool moves_by_itself(std::size_t slot) const {
    return moves_freely(slot) && !is_of_mesh(slot) && !is_part(slot);
  }
  /// With a prescribed velocity, or by Newton's law.
  bool moves(std::size_t slot) const { return kind[slot] >= BlockKind::prescribed; }
  bool has_deformable() const { return !deformations_.empty(); }
  bool is_affine(std::size_t slot) const { return kind[slot] == BlockKind::affine; }
  /// A cell at the surface of a mesh, moved by its nodes.
  bool is_of_mesh(std::size_t slot) const { return kind[slot] == BlockKind::mesh; }
  /// Components of a rigid block's motion that no force changes: bit k for axis k, bit D for its rotation.
  void hold(std::size_t slot, std::uint8_t components);
  bool any_held() const { return held_count_ > 0; }
  bool is_held(std::size_t slot, int component) const { return (held[slot] >> component & 1) != 0; }
  /// The part of a velocity change of a block that no support prevents.
  Vector<D> freed(std::size_t slot, Vector<D> change) const {
    for (int k = 0; k < D; ++k) {
      if (is_held(slot, k)) change[k] = 0;
    }
    return change;
  }
  Angular<D> freed_turn(std::size_t slot, const Angular<D>& change) const {
    return is_held(slot, D) ? Angular<D>(Angular<D>::Zero()) : change;
  }
  /// A convex part of a compound, moved by it, or a compound, which makes contacts by its parts only.
  bool is_part(std::size_t slot) const { return compounds_.is_part(slot); }
  bool is_compound(std::size_t slot) const { return compounds_.is_compound(slot); }
  /// The block whose mass resists a force on a slot: the compound of a part, else the slot itself.
  std::size_t mover_of(std::size_t slot) const {
    const std::int32_t compound = compounds_.compound_of(slot);
    return compound >= 0 ? std::size_t(compound) : slot;
  }
  /// From the centroid of the mover of a slot to that of the slot.
  Vector<D> arm_of(std::size_t slot) const { return position[slot] - position[mover_of(slot)]; }
  /// Has a uniform strain: an unknown of its own, or given by the nodes of its mesh.
  bool is_deformable(std::size_t slot) const { return kind[slot] >= BlockKind::affine; }
  /// Blocks joined by a bond or by a ring of bonds around a corner, parts of one compound, or cells of one
  /// mesh with a common node, are never in contact.
  bool are_joined(std::size_t a, std::size_t b) const {
    return (is_of_mesh(a) && is_of_mesh(b) && meshes_.are_joined(a, b)) || compounds_.are_joined(a, b) ||
           (!bonds_.empty() && (bonds_.keeps(std::int32_t(a), std::int32_t(b)) ||
                                bonds_.rings().hold(std::int32_t(a), std::int32_t(b))));
  }
  std::int64_t count() const { return living_; }

  std::int32_t add(const Shape<D>& shape, BlockKind block_kind, std::int32_t block_material, double density);
  /// Adds a compound with its centroid at the origin, and its convex parts, which share its kind and
  /// material. `poses`: of the shapes, in one frame. If memory runs out, nothing has changed.
  std::int32_t add_compound(std::span<const Shape<D>* const> shapes, std::span<const Pose<D>> poses,
                            BlockKind block_kind, std::int32_t block_material, double density);
  /// The entries of a block, and its outline in the frame of the shape, as add() takes them in another world.
  BlockState<D> state_of(std::size_t slot) const;
  void copy_outline(std::int32_t slot, OutlineCopy<D>& copy) const { outlines_.copy(slot, copy); }
  bool is_sound(const OutlineCopy<D>& copy) const { return outlines_.is_sound(copy); }
  std::int32_t add(const BlockState<D>& state, const OutlineCopy<D>& own);
  /// The same with the outline of a block of another world, between begin and end.
  void begin_taking_over(const Blocks& other, std::size_t count);
  std::int32_t add(const BlockState<D>& state, const Blocks& other, std::int32_t slot);
  /// Places an outline where the block is.
  void renew_outline(std::int32_t slot);
  void end_taking_over() { outlines_.end_taking_over(); }
  /// Undoes the last add_compound().
  void take_back_compound(std::int32_t compound);
  /// Removes a compound whose parts have been removed.
  void remove_compound(std::int32_t compound);
  /// Sets pose and velocities of a compound's part from those of the compound.
  void follow(const Part<D>& part);
  /// The same where only velocities have changed.
  void follow_velocity(const Part<D>& part);
  void remove(std::int32_t slot);
  /// Undoes the last add().
  void take_back(std::int32_t slot);

  /// Sets the pose of a block and its outline; the parts of a compound follow. The spin stays.
  void place(std::int32_t slot, const Vector<D>& to, const Rotation<D>& turned);
  void set_motion(std::int32_t slot, const Vector<D>& new_velocity, const Angular<D>& new_spin);
  /// Changes velocity and angular momentum. The spin is updated in the next drift.
  void push(std::size_t slot, const Vector<D>& velocity_change, const Angular<D>& momentum_change) {
    velocity[slot] += velocity_change;
    momentum[slot] += momentum_change;
  }
  /// The same with the spin, for a block that does not move in between.
  void kick(std::size_t slot, const Vector<D>& velocity_change, const Angular<D>& momentum_change) {
    push(slot, velocity_change, momentum_change);
    spin[slot] = inertia[slot].spin(momentum[slot], rotation[slot]);
  }
  /// The same for the deformation rate of an affine block.
  void strain(std::size_t slot, const Tensor<D>& rate_change) {
    deformation(slot).rate += rate_change;
    renew_spin(slot);
  }
  /// No block has moved since the spins were set.
  void forget_motion() { std::fill(mean_spin.begin(), mean_spin.end(), Angular<D>::Zero()); }
  /// Moves, rotates and strains an affine block at its present rate.
  void drift_affine(std::int32_t slot, const Vector<D>& way, double duration);
  /// Moves a block. Angular momentum of a rigid block is conserved; in 3D its spin changes.
  void drift(std::int32_t slot, const Vector<D>& way, const Rotation<D>& turned, double duration);

  Outline<D> outline(std::int32_t slot) const { return outlines_[slot]; }
  /// The largest inverse effective mass over the block's points, minus 1 / mass.
  double strain_mobility(std::size_t slot) const;
  /// In the frame of the shape.
  Outline<D> own_outline(std::int32_t slot) const { return outlines_.own(slot); }
  /// The deformation gradient; the rotation where the block does not deform.
  Tensor<D> gradient(std::size_t slot) const {
    return is_deformable(slot) ? deformation(slot).gradient : rotation[slot].tensor();
  }
  /// A place in space, in the frame of the shape.
  Vector<D> in_frame_of(std::size_t slot, const Vector<D>& place) const {
    return gradient(slot).inverse() * (place - position[slot]);
  }
  /// From the centroid to a place in the frame of the shape.
  Vector<D> arm_to(std::size_t slot, const Vector<D>& own) const { return gradient(slot) * own; }
  /// A lower bound of the thickness in the present deformation.
  double strained_thickness(std::size_t slot) const {
    return is_deformable(slot) ? thickness[slot] / deformation(slot).gradient.inverse().norm()
                               : thickness[slot];
  }
  double thinner(std::int32_t a, std::int32_t b) const {
    return std::min(strained_thickness(std::size_t(a)), strained_thickness(std::size_t(b)));
  }
  /// A bound of the speed of any point relative to the centroid, now.
  double swing(std::size_t slot) const {
    return radius[slot] * (is_deformable(slot) ? deformation(slot).rate.norm() : spin[slot].norm());
  }
  /// A bound of the relative speed of any two points of two blocks, now.
  double speed_between(std::int32_t a, std::int32_t b) const {
    const std::size_t i = std::size_t(a), j = std::size_t(b);
    return (velocity[j] - velocity[i]).norm() + swing(i) + swing(j);
  }
  /// The velocity of the point at `arm` from the centroid.
  Vector<D> velocity_at(std::size_t slot, const Vector<D>& arm) const {
    if (is_deformable(slot)) return velocity[slot] + deformation(slot).velocity_gradient() * arm;
    return velocity[slot] + swept(spin[slot], arm);
  }
  Deformation<D>& deformation(std::size_t slot) { return deformations_[slot]; }
  const Deformation<D>& deformation(std::size_t slot) const { return deformations_[slot]; }
  Deformations<D>& deformations() { return deformations_; }
  const Deformations<D>& deformations() const { return deformations_; }
  const Compounds<D>& compounds() const { return compounds_; }
  Bonds<D>& bonds() { return bonds_; }
  const Bonds<D>& bonds() const { return bonds_; }
  Meshes<D>& meshes() { return meshes_; }
  const Meshes<D>& meshes() const { return meshes_; }
  /// Makes a new block a cell of a mesh. `masses` are the cell's parts of its nodes' masses.
  void put_on_surface(const SurfaceCell<D>& cell, const Eigen::Matrix<double, D + 1, 1>& masses);
  /// Sets a mesh block's mass from the cell's parts of its nodes' masses.
  void weigh(const SurfaceCell<D>& cell, const Eigen::Matrix<double, D + 1, 1>& masses);
  /// Sets pose, deformation and velocities of a mesh block from its nodes. `duration`: of their last motion.
  void follow_nodes(const SurfaceCell<D>& cell, double duration = 0);
  /// The same where only velocities of nodes have changed.
  void follow_node_velocities(const SurfaceCell<D>& cell);
  /// Sets the deformation gradient of an affine block, and its rate, which was constant for a duration.
  void deform(std::int32_t slot, const Tensor<D>& gradient, const Tensor<D>& rate, double duration = 0);
  Face<D> undeformed_face(std::int32_t slot, int face) const { return face_of(outlines_.own(slot), face); }
  PlacedBlocks<D> placed(std::int32_t a, std::int32_t b) const {
    return {outline(a), outline(b), position[std::size_t(b)] - position[std::size_t(a)]};
  }
  Box<D> box(std::int32_t slot) const;
  /// The block in which a place is deepest; -1 if it is outside of all.
  std::int32_t containing(const Vector<D>& place) const;
  /// The maximum number of edges of a block.
  std::size_t max_edges() const;
  /// The maximum number of doubles in the outline of a block.
  std::size_t max_components() const;
  /// The reduced mass of two blocks, at least one of which moves freely.
  double reduced_mass(std::size_t a, std::size_t b) const {
    const auto inverse = [&](std::size_t i) { return moves_freely(i) ? 1 / mass[mover_of(i)] : 0; };
    return 1 / (inverse(a) + inverse(b));
  }
  /// For a rigid block.
  double kinetic_energy(std::int32_t slot) const {
    const std::size_t s = std::size_t(slot);
    return 0.5 * (mass[s] * velocity[s].squaredNorm() + spin[s].dot(momentum[s]));
  }

  /// False for data of a damaged snapshot. If true, no index read from it is out of range.
  bool is_consistent(std::int32_t material_count) const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(kind, material, generation, position, velocity, force, applied_force, rotation, angle, spin,
            momentum, torque, applied_torque, mass, inertia, radius, largest_face, thickness, held,
            held_count_, free_slots_, outlines_, deformations_, compounds_, meshes_, bonds_, living_,
            moving_end_);
    if constexpr (Archive::reads) {
      free_slots_.reserve(slot_count());
      mean_spin.resize(slot_count());
      forget_motion();
    }
  }

  Array<BlockKind> kind;
  Array<std::int32_t> material;
  Array<std::uint32_t> generation;
  Array<Vector<D>> position;  // of the centroid
  Array<Vector<D>> velocity;
  Array<Vector<D>> force;  // of the contacts
  Array<Vector<D>> applied_force;
  Array<Rotation<D>> rotation;
  Array<double> angle;  // of the rotation, with whole turns; only in 2D
  Array<Angular<D>> spin;
  Array<Angular<D>> mean_spin;  // in the last motion: times its duration and the mean of the arms of a point
                                // at both ends, the point's displacement by rotation
  Array<Angular<D>> momentum;   // angular
  Array<Angular<D>> torque;     // of the contacts
  Array<Angular<D>> applied_torque;
  Array<double> mass;
  Array<Inertia<D>> inertia;
  Array<double> radius;        // of the bounding circle or sphere
  Array<double> largest_face;  // area; in 2D the length of the longest edge
  Array<double> thickness;     // of the shape
  Array<std::uint8_t> held;    // bits, see hold(); 0 unless rigid

 private:
  /// The arrays with an entry per slot, but for the kind, and for the generation, which outlives its block.
  auto entries() {
    return std::tie(material, position, velocity, force, applied_force, rotation, spin, mean_spin, momentum,
                    torque, applied_torque, mass, inertia, radius, largest_face, thickness, held);
  }
  void resize(std::size_t slots);
  void empty(std::size_t slot);
  std::int32_t add(const BlockState<D>& state, const typename Outlines<D>::Taken& outline);
  std::int32_t occupy(const typename Outlines<D>::Taken& outline, BlockKind block_kind,
                      std::int32_t block_material);
  void follow(std::int32_t compound);
  void follow_velocity(std::int32_t compound);
  void set_rotation(std::size_t slot, const Rotation<D>& turned);
  void renew_spin(std::size_t slot, double duration = 0);

  Array<std::int32_t> free_slots_;  // capacity for all slots
  Outlines<D> outlines_;
  Deformations<D> deformations_;
  Compounds<D> compounds_;
  Meshes<D> meshes_;
  Bonds<D> bonds_;
  std::int64_t living_ = 0;
  std::int64_t moving_end_ = 0;
  std::int64_t held_count_ = 0;  // blocks with held components
};

extern template class Blocks<2>;
extern template class Blocks<3>;

}  // namespace halfspace
