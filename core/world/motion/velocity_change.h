#pragma once

#include "block/blocks.h"
#include "geometry/numbers.h"
#include "world/motion/block_motion.h"

namespace halfspace {

/// A material point of a block: in a mesh, weights of nodes; else the arm from the centroid, for an affine
/// block in the frame of its shape. Without implicit padding.
template <int D>
struct MaterialPoint {
  std::int32_t block = -1;
  std::array<std::int32_t, 3> node{};  // the first D are used
  Vector<D> weight = Vector<D>::Zero();
  Vector<D> arm = Vector<D>::Zero();
};

/// The weighted sum of nodal vectors at a point of a mesh.
template <int D, class OfNode>
Vector<D> weighed(const MaterialPoint<D>& point, OfNode of_node) {
  Vector<D> sum = Vector<D>::Zero();
  for (int i = 0; i < D; ++i) {
    if (point.weight[i] != 0) sum += point.weight[i] * of_node(std::size_t(point.node[std::size_t(i)]));
  }
  return sum;
}

/// Velocity changes by impulses at points. Empty in a world without any.
template <int D>
class VelocityChange {
 public:
  VelocityChange(const Blocks<D>& blocks, Memory* memory)
      : blocks_(blocks), of_node_(memory), of_block_(memory), momentum_(memory), of_gradient_(memory) {}

  bool empty() const { return of_block_.empty(); }
  /// Allocates and zeroes the changes, for one half of a motion of this duration.
  void begin(double duration) {
    rate_ = 2 / duration;
    of_block_.assign(blocks_.moving_end(), Vector<D>::Zero());
    momentum_.assign(blocks_.moving_end(), Angular<D>::Zero());
    of_gradient_.assign(blocks_.has_deformable() ? blocks_.moving_end() : 0, Tensor<D>::Zero());
    of_node_.assign(blocks_.meshes().node_count(), Vector<D>::Zero());
  }
  void swap(VelocityChange& other) noexcept {
    of_node_.swap(other.of_node_);
    of_block_.swap(other.of_block_);
    momentum_.swap(other.momentum_);
    of_gradient_.swap(other.of_gradient_);
    std::swap(rate_, other.rate_);
  }
  void end() {
    of_block_.clear();
    momentum_.clear();
    of_gradient_.clear();
    of_node_.clear();
  }

  // Zero for blocks that do not move, and for blocks and nodes added since begin().
  Vector<D> of_node(std::size_t node) const { return of(of_node_, node, Vector<D>(Vector<D>::Zero())); }
  Vector<D> of_block(std::size_t slot) const { return of(of_block_, slot, Vector<D>(Vector<D>::Zero())); }
  Angular<D> momentum(std::size_t slot) const { return of(momentum_, slot, Angular<D>(Angular<D>::Zero())); }
  Tensor<D> of_gradient(std::size_t slot) const {
    return of(of_gradient_, slot, Tensor<D>(Tensor<D>::Zero()));
  }
  /// Mean force per impulse over its half of the motion, 1/s.
  double rate() const { return rate_; }

  void set(std::size_t slot, const Vector<D>& velocity, const Angular<D>& momentum) {
    of_block_[slot] = velocity;
    momentum_[slot] = momentum;
  }
  /// Gives a block the same mean force as another change did.
  void take_over(std::size_t slot, const VelocityChange& other) {
    const double scale = other.rate() / rate_;
    of_block_[slot] = scale * other.of_block(slot);
    momentum_[slot] = scale * other.momentum(slot);
  }
  /// The change of a point's velocity.
  Vector<D> at(const MaterialPoint<D>& point) const;
  /// The change of a rigid block's motion; none for blocks that do not move freely.
  BlockMotion<D> of_motion(std::size_t slot) const {
    if (blocks_.kind[slot] != BlockKind::rigid) return {};
    return {of_block_[slot], blocks_.inertia[slot].spin(momentum_[slot], blocks_.rotation[slot])};
  }
  /// Replaces the change of a rigid block.
  void set_motion(std::size_t slot, const BlockMotion<D>& change) {
    of_block_[slot] = change.velocity;
    momentum_[slot] = blocks_.inertia[slot].momentum(change.spin, blocks_.rotation[slot]);
  }
  /// An impulse and its moment on a block, which is ignored unless it is rigid.
  void push(std::size_t slot, const Vector<D>& impulse, const Angular<D>& moment) {
    if (blocks_.kind[slot] != BlockKind::rigid) return;
    of_block_[slot] += impulse / blocks_.mass[slot];
    momentum_[slot] += moment;
  }
  /// Applies an impulse at a point.
  void add(const MaterialPoint<D>& point, const Vector<D>& impulse);

  /// Validates the state read from a snapshot.
  bool is_consistent() const {
    return momentum_.size() == of_block_.size() && of_block_.size() <= blocks_.slot_count() &&
           of_gradient_.size() <= of_block_.size() && of_node_.size() <= blocks_.meshes().node_count() &&
           is_nonnegative(rate_);
  }
  template <class Archive>
  void visit(Archive& archive) {
    archive(of_node_, of_block_, momentum_, of_gradient_, rate_);
  }

 private:
  template <class T>
  static T of(const Array<T>& kicks, std::size_t which, const T& none) {
    return which < kicks.size() ? kicks[which] : none;
  }

  const Blocks<D>& blocks_;
  Array<Vector<D>> of_node_;
  Array<Vector<D>> of_block_;
  Array<Angular<D>> momentum_;    // of angular momentum
  Array<Tensor<D>> of_gradient_;  // of the gradient's rate, for affine blocks
  double rate_ = 0;
};

/// The current position of a point.
template <int D>
Vector<D> place_of(const MaterialPoint<D>& point, const Blocks<D>& blocks);
/// Its current velocity.
template <int D>
Vector<D> velocity_of(const MaterialPoint<D>& point, const Blocks<D>& blocks);
/// The prescribed part of it, which no force changes.
template <int D>
Vector<D> prescribed_velocity_of(const MaterialPoint<D>& point, const Blocks<D>& blocks);
/// The inverse effective mass: change of a point's velocity per impulse.
template <int D>
Tensor<D> inverse_mass_at(const MaterialPoint<D>& point, const Blocks<D>& blocks);

extern template class VelocityChange<2>;
extern template class VelocityChange<3>;
extern template Vector<2> place_of(const MaterialPoint<2>&, const Blocks<2>&);
extern template Vector<3> place_of(const MaterialPoint<3>&, const Blocks<3>&);
extern template Vector<2> velocity_of(const MaterialPoint<2>&, const Blocks<2>&);
extern template Vector<3> velocity_of(const MaterialPoint<3>&, const Blocks<3>&);
extern template Vector<2> prescribed_velocity_of(const MaterialPoint<2>&, const Blocks<2>&);
extern template Vector<3> prescribed_velocity_of(const MaterialPoint<3>&, const Blocks<3>&);
extern template Tensor<2> inverse_mass_at(const MaterialPoint<2>&, const Blocks<2>&);
extern template Tensor<3> inverse_mass_at(const MaterialPoint<3>&, const Blocks<3>&);

}  // namespace halfspace
