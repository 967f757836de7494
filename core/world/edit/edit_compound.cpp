#include <algorithm>

#include "geometry/tolerances.h"
#include "narrow_phase/pair.h"
#include "world/world.h"

// External edits: compounds.

namespace halfspace {

namespace {

/// The first two parts of a compound that overlap, if any.
template <int D>
PartOverlap overlap_of_parts(const Blocks<D>& blocks, std::int32_t compound) {
  const std::span<const Part<D>> parts = blocks.compounds().parts_of(std::size_t(compound));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Box<D> box = blocks.box(parts[i].block);
    for (std::size_t k = i + 1; k < parts.size(); ++k) {
      const std::int32_t a = parts[i].block, b = parts[k].block;
      if (!box.overlaps(blocks.box(b))) continue;
      const PlacedBlocks<D> at = blocks.placed(a, b);
      const double depth = -find_largest_separation(at.a, at.b, at.to_b).gap;
      if (depth > touch_reach * std::min(blocks.radius[std::size_t(a)], blocks.radius[std::size_t(b)]))
        return {std::int32_t(i), std::int32_t(k), depth};
    }
  }
  return {};
}

}  // namespace

template <int D>
PlacedCompound World<D>::add_compound(std::span<const Shape<D>* const> shapes, std::span<const Pose<D>> poses,
                                      BlockKind kind, std::int32_t material, const Pose<D>& pose) {
  Blocks<D>& blocks = model_.blocks;
  state_.contacts.make_room_for_blocks(blocks.slot_count() + shapes.size() + 1);
  PlacedCompound placed;
  placed.block = blocks.add_compound(shapes, poses, kind, material, model_.materials.density(material));
  placed.overlap = overlap_of_parts(blocks, placed.block);
  if (placed.overlap.depth > 0) {
    blocks.take_back_compound(placed.block);
    return placed;
  }
  for (const Part<D>& part : blocks.compounds().parts_of(std::size_t(placed.block)))
    state_.note_added(part.block);
  set_pose(placed.block, pose.position, pose.rotation);
  return placed;
}

template <int D>
void World<D>::remove_compound(std::int32_t slot) {
  for (const Part<D>& part : model_.blocks.compounds().parts_of(std::size_t(slot))) remove_block(part.block);
  remove_block(slot);
}

#define HALFSPACE_MEMBERS(D)                                                                                 \
  template PlacedCompound World<D>::add_compound(std::span<const Shape<D>* const>, std::span<const Pose<D>>, \
                                                 BlockKind, std::int32_t, const Pose<D>&);                   \
  template void World<D>::remove_compound(std::int32_t);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
