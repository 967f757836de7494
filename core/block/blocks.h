#pragma once

#include <algorithm>
#include <cstdint>

#include "block/bond/bonds.h"
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

/// How a block moves. The values are those of the C API; `none` marks a free slot.
enum class BlockKind : std::int32_t { none = -1, fixed = 0, prescribed = 1, rigid = 2, affine = 3, mesh = 4 };

/// Two blocks where they are: their outlines, and the way from a's centroid to b's.
template <int D>
struct PlacedBlocks {
  Outline<D> a;
  Outline<D> b;
  Vector<D> to_b;
};

/// All blocks of a world, a component to an array. Slots of removed blocks are used again, under a new
/// generation.
template <int D>
class Blocks {
 public:
  explicit Blocks(Memory* memory);

  std::size_t slot_count() const { return kind.size(); }
  bool lives(std::size_t slot) const { return kind[slot] != BlockKind::none; }
  /// By Newton's law.
  bool moves_freely(std::size_t slot) const { return kind[slot] >= BlockKind::rigid; }
  /// As it is told to, or by Newton's law.
  bool moves(std::size_t slot) const { return kind[slot] >= BlockKind::prescribed; }
  bool has_deformable() const { return !deformations_.empty(); }
  bool is_affine(std::size_t slot) const { return kind[slot] == BlockKind::affine; }
  /// At the surface of a mesh, whose nodes move it.
  bool is_of_mesh(std::size_t slot) const { return kind[slot] == BlockKind::mesh; }
  /// Strains as a whole: as an unknown of its own, or as the nodes of its mesh do.
  bool is_deformable(std::size_t slot) const { return kind[slot] >= BlockKind::affine; }
  /// Two blocks that a bond holds, or a ring of bonds around a corner, or of one mesh and with a common node,
  /// never touch.
  bool are_joined(std::size_t a, std::size_t b) const {
    return (is_of_mesh(a) && is_of_mesh(b) && meshes_.are_joined(a, b)) ||
           (!bonds_.empty() && (bonds_.keeps(std::int32_t(a), std::int32_t(b)) ||
                                bonds_.rings().hold(std::int32_t(a), std::int32_t(b))));
  }
  std::int64_t count() const { return living_; }

  std::int32_t add(const Shape<D>& shape, BlockKind block_kind, std::int32_t block_material, double density);
  void remove(std::int32_t slot);
  /// Takes the block back that was added last, as if it had never been.
  void take_back(std::int32_t slot);

  /// Puts a block somewhere and turns its outline. Its spin stays.
  void place(std::int32_t slot, const Vector<D>& to, const Rotation<D>& turned);
  void set_motion(std::int32_t slot, const Vector<D>& new_velocity, const Angular<D>& new_spin);
  /// Changes velocity and angular momentum. The spin follows where the block drifts on.
  void push(std::size_t slot, const Vector<D>& velocity_change, const Angular<D>& momentum_change) {
    velocity[slot] += velocity_change;
    momentum[slot] += momentum_change;
  }
  /// The same for a block that stays where it is, its spin included.
  void kick(std::size_t slot, const Vector<D>& velocity_change, const Angular<D>& momentum_change) {
    push(slot, velocity_change, momentum_change);
    spin[slot] = inertia[slot].spin(momentum[slot], rotation[slot]);
  }
  /// The same for the deformation of an affine block.
  void strain(std::size_t slot, const Tensor<D>& rate_change) {
    deformation(slot).rate += rate_change;
    renew_spin(slot);
  }
  /// Moves an affine block, and turns and strains it at the present rate.
  void drift_affine(std::int32_t slot, const Vector<D>& way, double duration);
  /// Moves a block: a rigid one goes on under its own momentum, which stays while in space its spin changes.
  void drift(std::int32_t slot, const Vector<D>& way, const Rotation<D>& turned);

  Outline<D> outline(std::int32_t slot) const { return outlines_[slot]; }
  /// The acceleration over the force, beside that of the whole block, of the point that a force moves most.
  double strain_mobility(std::size_t slot) const;
  /// In its shape's frame.
  Outline<D> own_outline(std::int32_t slot) const { return outlines_.own(slot); }
  /// As the shape is turned, and strained.
  Tensor<D> gradient(std::size_t slot) const {
    return is_deformable(slot) ? deformation(slot).gradient : rotation[slot].tensor();
  }
  /// As thick as it is strained, or less.
  double strained_thickness(std::size_t slot) const {
    return is_deformable(slot) ? thickness[slot] / deformation(slot).gradient.inverse().norm()
                               : thickness[slot];
  }
  double thinner(std::int32_t a, std::int32_t b) const {
    return std::min(strained_thickness(std::size_t(a)), strained_thickness(std::size_t(b)));
  }
  /// How fast the points of a block move at most beside its centroid, now.
  double swing(std::size_t slot) const {
    return radius[slot] * (is_deformable(slot) ? deformation(slot).rate.norm() : spin[slot].norm());
  }
  /// At most: of any point of one against any of the other, now.
  double speed_between(std::int32_t a, std::int32_t b) const {
    const std::size_t i = std::size_t(a), j = std::size_t(b);
    return (velocity[j] - velocity[i]).norm() + swing(i) + swing(j);
  }
  /// The velocity of a point of a block, at a place seen from its centroid.
  Vector<D> velocity_at(std::size_t slot, const Vector<D>& arm) const {
    if (is_deformable(slot)) return velocity[slot] + deformation(slot).velocity_gradient() * arm;
    return velocity[slot] + swept(spin[slot], arm);
  }
  /// The deformation of a deformable block.
  Deformation<D>& deformation(std::size_t slot) { return deformations_[slot]; }
  const Deformation<D>& deformation(std::size_t slot) const { return deformations_[slot]; }
  /// The deformations of all deformable blocks.
  Deformations<D>& deformations() { return deformations_; }
  const Deformations<D>& deformations() const { return deformations_; }
  Bonds<D>& bonds() { return bonds_; }
  const Bonds<D>& bonds() const { return bonds_; }
  /// The bodies that the blocks of meshes belong to.
  Meshes<D>& meshes() { return meshes_; }
  const Meshes<D>& meshes() const { return meshes_; }
  /// Makes a new block one of a mesh. `masses` are those of its nodes, as far as they are its own.
  void put_on_surface(const SurfaceCell<D>& cell, const Eigen::Matrix<double, D + 1, 1>& masses);
  /// Gives a block of a mesh the mass of its nodes, as far as it is its own.
  void weigh(const SurfaceCell<D>& cell, const Eigen::Matrix<double, D + 1, 1>& masses);
  /// Puts a block of a mesh where its nodes are, and moves it as they do.
  void follow_nodes(const SurfaceCell<D>& cell);
  /// The same where the nodes' velocities have changed alone.
  void follow_node_velocities(const SurfaceCell<D>& cell);
  /// Sets how an affine block is turned and strained, and how fast.
  void deform(std::int32_t slot, const Tensor<D>& gradient, const Tensor<D>& rate);
  Face<D> undeformed_face(std::int32_t slot, int face) const { return face_of(outlines_.own(slot), face); }
  PlacedBlocks<D> placed(std::int32_t a, std::int32_t b) const {
    return {outline(a), outline(b), position[std::size_t(b)] - position[std::size_t(a)]};
  }
  Box<D> box(std::int32_t slot) const;
  /// The edges of the block that has most of them.
  std::size_t most_edges() const;
  /// How many doubles the largest block takes that is deformed.
  std::size_t most_components() const;
  /// The mass that two blocks move together, of which one at least moves freely.
  double reduced_mass(std::size_t a, std::size_t b) const {
    const auto inverse = [&](std::size_t i) { return moves_freely(i) ? 1 / mass[i] : 0; };
    return 1 / (inverse(a) + inverse(b));
  }
  /// For a rigid block.
  double kinetic_energy(std::int32_t slot) const {
    const std::size_t s = std::size_t(slot);
    return 0.5 * (mass[s] * velocity[s].squaredNorm() + spin[s].dot(momentum[s]));
  }

  /// False for what no blocks can be, after reading a snapshot: nothing read from it can then lead out of the
  /// arrays.
  bool is_consistent(std::int32_t material_count) const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(kind, material, generation, position, velocity, force, applied_force, rotation, angle, spin,
            momentum, torque, applied_torque, mass, inertia, radius, largest_face, thickness, free_slots_,
            outlines_, deformations_, meshes_, bonds_, living_);
    if constexpr (Archive::reads) free_slots_.reserve(slot_count());
  }

  Array<BlockKind> kind;
  Array<std::int32_t> material;
  Array<std::uint32_t> generation;
  Array<Vector<D>> position;  // of the centroid
  Array<Vector<D>> velocity;
  Array<Vector<D>> force;  // of the contacts
  Array<Vector<D>> applied_force;
  Array<Rotation<D>> rotation;
  Array<double> angle;  // in the plane: that of the rotation, counting whole turns
  Array<Angular<D>> spin;
  Array<Angular<D>> momentum;  // angular
  Array<Angular<D>> torque;    // of the contacts
  Array<Angular<D>> applied_torque;
  Array<double> mass;
  Array<Inertia<D>> inertia;
  Array<double> radius;        // of the bounding circle or sphere
  Array<double> largest_face;  // its area; in the plane the length of the longest edge
  Array<double> thickness;     // of the shape

 private:
  void resize(std::size_t slots);
  void set_rotation(std::size_t slot, const Rotation<D>& turned);
  void renew_spin(std::size_t slot);

  Array<std::int32_t> free_slots_;  // there is room for all
  Outlines<D> outlines_;
  Deformations<D> deformations_;
  Meshes<D> meshes_;
  Bonds<D> bonds_;
  std::int64_t living_ = 0;
};

extern template class Blocks<2>;
extern template class Blocks<3>;

}  // namespace halfspace
