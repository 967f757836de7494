#include "world/motion/velocity_change.h"

namespace halfspace {
namespace {

template <int D>
bool is_held(const Meshes<D>& meshes, std::size_t node, int component) {
  return (meshes.held[node] >> component & 1) != 0;
}

/// From the centroid of the block that moves the point.
template <int D>
Vector<D> arm_of(const MaterialPoint<D>& point, const Blocks<D>& blocks) {
  const std::size_t slot = std::size_t(point.block);
  return blocks.is_part(slot) ? Vector<D>(point.arm + blocks.arm_of(slot)) : point.arm;
}

}  // namespace

template <int D>
Vector<D> VelocityChange<D>::at(const MaterialPoint<D>& point) const {
  const std::size_t slot = blocks_.mover_of(std::size_t(point.block));
  switch (blocks_.kind[slot]) {
    case BlockKind::mesh:
      return weighed(point, [&](std::size_t node) { return of_node_[node]; });
    case BlockKind::rigid:
      return of_block_[slot] + swept(blocks_.inertia[slot].spin(momentum_[slot], blocks_.rotation[slot]),
                                     arm_of(point, blocks_));
    case BlockKind::affine:
      return of_block_[slot] + of_gradient_[slot] * point.arm;
    default:
      return Vector<D>::Zero();
  }
}

template <int D>
void VelocityChange<D>::add(const MaterialPoint<D>& point, const Vector<D>& impulse) {
  const std::size_t slot = blocks_.mover_of(std::size_t(point.block));
  const Meshes<D>& meshes = blocks_.meshes();
  switch (blocks_.kind[slot]) {
    case BlockKind::mesh:
      for (int i = 0; i < D; ++i) {
        if (point.weight[i] == 0) continue;
        const std::size_t node = std::size_t(point.node[std::size_t(i)]);
        for (int k = 0; k < D; ++k) {
          if (!is_held(meshes, node, k))
            of_node_[node][k] += point.weight[i] * impulse[k] / meshes.mass[node];
        }
      }
      break;
    case BlockKind::rigid:
      of_block_[slot] += blocks_.freed(slot, impulse / blocks_.mass[slot]);
      momentum_[slot] += blocks_.freed_turn(slot, moment(arm_of(point, blocks_), impulse));
      break;
    case BlockKind::affine:
      of_block_[slot] += impulse / blocks_.mass[slot];
      of_gradient_[slot] += impulse * point.arm.transpose() * blocks_.deformation(slot).inverse_mass_matrix;
      break;
    default:
      break;
  }
}

template <int D>
Vector<D> place_of(const MaterialPoint<D>& point, const Blocks<D>& blocks) {
  const std::size_t slot = std::size_t(point.block);
  const Meshes<D>& meshes = blocks.meshes();
  if (blocks.is_of_mesh(slot))
    return meshes.body(meshes.surface_of_block(slot).body).origin +
           weighed(point, [&](std::size_t node) { return meshes.place[node]; });
  const Vector<D> arm =
      blocks.is_affine(slot) ? Vector<D>(blocks.deformation(slot).gradient * point.arm) : point.arm;
  return blocks.position[slot] + arm;
}

template <int D>
Vector<D> velocity_of(const MaterialPoint<D>& point, const Blocks<D>& blocks) {
  const std::size_t slot = std::size_t(point.block);
  switch (blocks.kind[slot]) {
    case BlockKind::mesh:
      return weighed(point, [&](std::size_t node) { return blocks.meshes().velocity[node]; });
    case BlockKind::affine:
      return blocks.velocity[slot] + blocks.deformation(slot).rate * point.arm;
    case BlockKind::fixed:
      return Vector<D>::Zero();
    default:
      return blocks.velocity[slot] + swept(blocks.spin[slot], point.arm);
  }
}

template <int D>
Vector<D> prescribed_velocity_of(const MaterialPoint<D>& point, const Blocks<D>& blocks) {
  const Meshes<D>& meshes = blocks.meshes();
  switch (blocks.kind[std::size_t(point.block)]) {
    case BlockKind::prescribed:
      return velocity_of(point, blocks);
    case BlockKind::mesh:
      return weighed(point, [&](std::size_t node) {
        Vector<D> held = meshes.velocity[node];
        for (int k = 0; k < D; ++k) {
          if (!is_held(meshes, node, k)) held[k] = 0;
        }
        return held;
      });
    case BlockKind::rigid: {
      const std::size_t slot = blocks.mover_of(std::size_t(point.block));
      return blocks.velocity[slot] - blocks.freed(slot, blocks.velocity[slot]);
    }
    default:
      return Vector<D>::Zero();
  }
}

template <int D>
Tensor<D> inverse_mass_at(const MaterialPoint<D>& point, const Blocks<D>& blocks) {
  const std::size_t slot = blocks.mover_of(std::size_t(point.block));
  const Meshes<D>& meshes = blocks.meshes();
  Tensor<D> all = Tensor<D>::Zero();
  switch (blocks.kind[slot]) {
    case BlockKind::mesh:
      for (int i = 0; i < D; ++i) {
        if (point.weight[i] == 0) continue;
        const std::size_t node = std::size_t(point.node[std::size_t(i)]);
        for (int k = 0; k < D; ++k) {
          if (!is_held(meshes, node, k)) all(k, k) += point.weight[i] * point.weight[i] / meshes.mass[node];
        }
      }
      return all;
    case BlockKind::rigid: {
      const Vector<D> arm = arm_of(point, blocks);
      for (int k = 0; k < D; ++k) {
        const Angular<D> turned = blocks.freed_turn(slot, moment(arm, Vector<D>::Unit(k)));
        all.col(k) = blocks.freed(slot, Vector<D>::Unit(k) / blocks.mass[slot]) +
                     swept(blocks.inertia[slot].spin(turned, blocks.rotation[slot]), arm);
      }
      return all;
    }
    case BlockKind::affine: {
      const double yield = point.arm.dot(blocks.deformation(slot).inverse_mass_matrix * point.arm);
      return (1 / blocks.mass[slot] + yield) * Tensor<D>::Identity();
    }
    default:
      return all;
  }
}

template class VelocityChange<2>;
template class VelocityChange<3>;
template Vector<2> place_of(const MaterialPoint<2>&, const Blocks<2>&);
template Vector<3> place_of(const MaterialPoint<3>&, const Blocks<3>&);
template Vector<2> velocity_of(const MaterialPoint<2>&, const Blocks<2>&);
template Vector<3> velocity_of(const MaterialPoint<3>&, const Blocks<3>&);
template Vector<2> prescribed_velocity_of(const MaterialPoint<2>&, const Blocks<2>&);
template Vector<3> prescribed_velocity_of(const MaterialPoint<3>&, const Blocks<3>&);
template Tensor<2> inverse_mass_at(const MaterialPoint<2>&, const Blocks<2>&);
template Tensor<3> inverse_mass_at(const MaterialPoint<3>&, const Blocks<3>&);

}  // namespace halfspace
