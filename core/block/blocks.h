#pragma once

#include <cstdint>

#include "geometry/outline.h"
#include "geometry/rotation.h"
#include "geometry/shape.h"
#include "geometry/vector.h"
#include "neighbor/neighbor_search.h"

namespace halfspace {

/// How a block moves. The values are those of the C API; `none` marks a free slot.
enum class BlockKind : std::int32_t { none = -1, fixed = 0, prescribed = 1, rigid = 2 };

/// All blocks of a world, a component to an array. Slots of removed blocks are used again, under a new
/// generation.
template <int D>
class Blocks;

template <>
class Blocks<2> {
 public:
  explicit Blocks(Memory* memory);

  std::size_t slot_count() const { return kind.size(); }
  bool lives(std::size_t slot) const { return kind[slot] != BlockKind::none; }
  std::int64_t count() const { return living_; }

  std::int32_t add(const Shape<2>& shape, BlockKind block_kind, std::int32_t block_material, double density);
  void remove(std::int32_t slot);

  /// Puts a block somewhere and turns its outline.
  void place(std::int32_t slot, const Vector<2>& to, const Rotation<2>& turned);
  /// Turns the outline of a block whose rotation has changed.
  void turn_outline(std::int32_t slot);

  Outline<2> outline(std::int32_t slot) const;
  Box<2> box(std::int32_t slot) const;
  double kinetic_energy(std::int32_t slot) const {
    return 0.5 * (mass[std::size_t(slot)] * velocity[std::size_t(slot)].squaredNorm() +
                  inertia[std::size_t(slot)] * spin[std::size_t(slot)] * spin[std::size_t(slot)]);
  }

  /// False for what no blocks can be, after reading a snapshot: nothing read from it can then lead out of the
  /// arrays.
  bool is_consistent(std::int32_t material_count) const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(kind, material, generation, position, velocity, force, applied_force, rotation, angle, spin,
            torque, applied_torque, mass, inertia, radius, longest_edge, free_slots_, first_, vertex_count_,
            own_, turned_, living_);
  }

  Array<BlockKind> kind;
  Array<std::int32_t> material;
  Array<std::uint32_t> generation;
  Array<Vector<2>> position;  // of the centroid
  Array<Vector<2>> velocity;
  Array<Vector<2>> force;  // of the contacts
  Array<Vector<2>> applied_force;
  Array<Rotation<2>> rotation;
  Array<double> angle;  // turned in all
  Array<double> spin;
  Array<double> torque;  // of the contacts
  Array<double> applied_torque;
  Array<double> mass;
  Array<double> inertia;
  Array<double> radius;  // of the bounding circle
  Array<double> longest_edge;

 private:
  void resize(std::size_t slots);
  void drop_outline(std::int32_t slot);

  Array<std::int32_t> free_slots_;
  Array<std::int64_t> first_;  // of the block's components in own_ and turned_
  Array<std::int32_t> vertex_count_;
  // Per block x, y, nx, ny, offset, each padded: what one block needs lies together.
  Array<double> own_;     // in the shape's frame
  Array<double> turned_;  // in the world's orientation, about the centroid
  std::int64_t living_ = 0;
};

}  // namespace halfspace
