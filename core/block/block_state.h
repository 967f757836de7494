#pragma once

#include <cstdint>

#include "block/block_kind.h"
#include "block/deformation.h"
#include "block/inertia.h"
#include "geometry/outline.h"
#include "geometry/rotation.h"
#include "geometry/vector.h"

namespace halfspace {

/// A block's entry in each column of Blocks. Not for cells of meshes and parts of compounds.
template <int D>
struct BlockState {
  BlockKind kind = BlockKind::none;
  std::int32_t material = 0;
  std::uint32_t generation = 0;
  std::uint8_t held = 0;
  Vector<D> position = Vector<D>::Zero();
  Vector<D> velocity = Vector<D>::Zero();
  Vector<D> force = Vector<D>::Zero();
  Vector<D> applied_force = Vector<D>::Zero();
  Rotation<D> rotation;
  double angle = 0;  // only in 2D
  Angular<D> spin = Angular<D>::Zero();
  Angular<D> momentum = Angular<D>::Zero();
  Angular<D> torque = Angular<D>::Zero();
  Angular<D> applied_torque = Angular<D>::Zero();
  double mass = 0;
  Inertia<D> inertia;
  double radius = 0;
  double largest_face = 0;
  double thickness = 0;
  Deformation<D> deformation;  // only of an affine block

  template <class Archive>
  void visit(Archive& archive) {
    archive(kind, material, generation, held, position, velocity, force, applied_force, rotation, angle, spin,
            momentum, torque, applied_torque, mass, inertia, radius, largest_face, thickness);
    if (kind == BlockKind::affine) archive(deformation);
  }
};

/// The outline of a block in the frame of its shape, in memory of its own.
template <int D>
struct OutlineCopy {
  explicit OutlineCopy(Memory* memory) : components(memory), topology(memory) {}

  /// Do the arrays have the lengths that follow from the counts?
  bool is_complete() const;

  std::int32_t vertices = 0;
  std::int32_t edges = 0;
  std::int32_t faces = 0;
  Array<double> components;      // x, y, nx, ny, offset, or x, y, z, nx, ny, nz, offset, each padded
  Array<std::int32_t> topology;  // the arrays of Topology, one after the other; empty in 2D

  template <class Archive>
  void visit(Archive& archive) {
    archive(vertices, edges, faces, components, topology);
  }
};

}  // namespace halfspace
