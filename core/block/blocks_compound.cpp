#include <algorithm>

#include "block/blocks.h"

// Compounds and their parts as blocks.

namespace halfspace {

template <int D>
std::int32_t Blocks<D>::add_compound(std::span<const Shape<D>* const> shapes, std::span<const Pose<D>> poses,
                                     BlockKind block_kind, std::int32_t block_material, double density) {
  const CompoundBody<D> body = compound_body(shapes, poses, density);
  compounds_.make_room(shapes.size(), slot_count() + shapes.size() + 1);
  const std::int32_t compound = occupy(outlines_.take_in_none(), block_kind, block_material);
  const std::size_t c = std::size_t(compound);
  mass[c] = body.mass;
  inertia[c] = body.inertia;
  radius[c] = body.radius;
  largest_face[c] = 0;
  thickness[c] = body.radius;
  compounds_.add(compound);
  try {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      Part<D> part;
      part.pose = {poses[i].position - body.centroid, poses[i].rotation};
      part.block = add(*shapes[i], block_kind, block_material, density);
      part.compound = compound;
      compounds_.add(part);
      largest_face[c] = std::max(largest_face[c], largest_face[std::size_t(part.block)]);
      thickness[c] = std::min(thickness[c], thickness[std::size_t(part.block)]);
    }
  } catch (...) {
    take_back_compound(compound);
    throw;
  }
  place(compound, Vector<D>::Zero(), Rotation<D>());
  set_motion(compound, Vector<D>::Zero(), Angular<D>::Zero());
  return compound;
}

template <int D>
void Blocks<D>::take_back_compound(std::int32_t compound) {
  const std::span<const Part<D>> parts = compounds_.parts_of(std::size_t(compound));
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) take_back(part->block);
  compounds_.remove(compound);
  take_back(compound);
}

template <int D>
void Blocks<D>::remove_compound(std::int32_t compound) {
  compounds_.remove(compound);
  remove(compound);
}

template <int D>
void Blocks<D>::follow(std::int32_t compound) {
  for (const Part<D>& part : compounds_.parts_of(std::size_t(compound))) follow(part);
}

template <int D>
void Blocks<D>::follow_velocity(std::int32_t compound) {
  for (const Part<D>& part : compounds_.parts_of(std::size_t(compound))) follow_velocity(part);
}

template <int D>
void Blocks<D>::follow(const Part<D>& part) {
  const std::size_t p = std::size_t(part.block), c = std::size_t(part.compound);
  position[p] = position[c] + rotation[c] * part.pose.position;
  set_rotation(p, rotation[c] * part.pose.rotation);
  outlines_.turn(part.block, rotation[p]);
  follow_velocity(part);
}

template <int D>
void Blocks<D>::follow_velocity(const Part<D>& part) {
  const std::size_t p = std::size_t(part.block), c = std::size_t(part.compound);
  velocity[p] = velocity_at(c, position[p] - position[c]);
  spin[p] = spin[c];
}

#define HALFSPACE_MEMBERS(D)                                                                                \
  template std::int32_t Blocks<D>::add_compound(std::span<const Shape<D>* const>, std::span<const Pose<D>>, \
                                                BlockKind, std::int32_t, double);                           \
  template void Blocks<D>::take_back_compound(std::int32_t);                                                \
  template void Blocks<D>::remove_compound(std::int32_t);                                                   \
  template void Blocks<D>::follow(std::int32_t);                                                            \
  template void Blocks<D>::follow_velocity(std::int32_t);                                                   \
  template void Blocks<D>::follow(const Part<D>&);                                                          \
  template void Blocks<D>::follow_velocity(const Part<D>&);

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
