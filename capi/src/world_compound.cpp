#include "block_definition.h"
#include "halfspace/compound.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

/// The parts of a compound to be.
template <int D>
struct GivenParts {
  Array<const Shape<D>*> shapes;
  Array<Pose<D>> poses;
};

constexpr int part_count_bits = 20;

template <int D>
GivenParts<D> read_parts(const hs_shape* const shapes[], const hs_pose poses[], std::int64_t count,
                         Memory* memory) {
  require_numbered(count, "part_count", part_count_bits);
  if (count == 0) refuse(HS_ERROR_ARGUMENT, "part_count is 0; it must be at least 1");
  require_pointer(shapes, "shapes");
  GivenParts<D> parts{Array<const Shape<D>*>(memory), Array<Pose<D>>(memory)};
  for (std::int64_t i = 0; i < count; ++i) {
    const Shape<D>& shape = require_shape<D>(shapes[i], {"shapes", i});
    parts.shapes.push_back(&shape);
    parts.poses.push_back(poses ? read_place<D>(&poses[i], shape.bounding_radius(), {"poses", i})
                                : Pose<D>{shape.centroid(), Rotation<D>()});
  }
  return parts;
}

}  // namespace

hs_status hs_compound_def_init(hs_block_def* def, size_t size, const hs_shape* const shapes[],
                               const hs_pose poses[], int64_t part_count) {
  if (!shapes || part_count < 1 || !shapes[0]) return HS_ERROR_ARGUMENT;
  return guarded(shapes[0]->context, __func__, [&] {
    return visit(*shapes[0], [&]<int D>(const Shape<D>&) -> hs_status {
      const GivenParts<D> parts = read_parts<D>(shapes, poses, part_count, &shapes[0]->context->memory);
      const hs_status status = hs_block_def_init(def, size, shapes[0]);
      if (status != HS_OK) return status;
      write_vector(compound_body<D>(parts.shapes, parts.poses, 1).centroid, def->pose.position);
      return HS_OK;
    });
  });
}

hs_status hs_world_add_compound(hs_world* world, const hs_shape* const shapes[], const hs_pose poses[],
                                int64_t part_count, const hs_block_def* def, hs_block* block) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    require_pointer(block, "block");
    const GivenParts<D> parts = read_parts<D>(shapes, poses, part_count, &world->context->memory);
    const double radius = compound_body<D>(parts.shapes, parts.poses, 1).radius;
    const BlockStart<D> start =
        read_block(w, def, radius, HS_BLOCK_RIGID, "HS_BLOCK_FIXED, HS_BLOCK_PRESCRIBED or HS_BLOCK_RIGID");
    const double density = w.model().materials.density(start.material);
    for (std::size_t i = 0; i < parts.shapes.size(); ++i) {
      const Shape<D>& shape = *parts.shapes[i];
      require_mass(mass_of(shape, density), Inertia<D>::of(shape, density), {"shapes", std::int64_t(i)});
    }
    const CompoundBody<D> body = compound_body<D>(parts.shapes, parts.poses, density);
    require_mass(body.mass, body.inertia, "shapes");
    require_energy(body.mass, body.inertia, start.pose.rotation, start.velocity, start.spin, "def.");
    const PlacedCompound placed =
        w.add_compound(parts.shapes, parts.poses, start.kind, start.material, start.pose);
    if (placed.overlap.depth > 0) {
      refuse(HS_ERROR_GEOMETRY,
             "shapes[%d] and shapes[%d] overlap by %g at their poses; parts of a compound may only touch",
             placed.overlap.a, placed.overlap.b, placed.overlap.depth);
    }
    w.set_velocity(placed.block, start.velocity, start.spin);
    *block = id_of(w.blocks(), std::size_t(placed.block));
    return HS_OK;
  });
}

hs_status hs_world_get_compound_parts(const hs_world* world, hs_block block, hs_block parts[],
                                      int64_t capacity, int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(parts, "parts");
    const Blocks<D>& blocks = w.blocks();
    const std::size_t slot = std::size_t(slot_of(blocks, block, "block"));
    std::span<const Part<D>> all;
    if (blocks.is_compound(slot)) all = blocks.compounds().parts_of(slot);
    const std::int64_t size = std::int64_t(all.size());
    if (count) *count = size;
    for (std::int64_t i = 0; i < std::min(size, capacity); ++i)
      parts[i] = id_of(blocks, std::size_t(all[std::size_t(i)].block));
    return fits(size, capacity);
  });
}

hs_status hs_world_get_compound_of_block(const hs_world* world, hs_block block, hs_block* compound,
                                         int32_t* part) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_pointer(compound, "compound");
    const Blocks<D>& blocks = w.blocks();
    const std::size_t slot = std::size_t(slot_of(blocks, block, "block"));
    const bool is_part = blocks.is_part(slot);
    *compound = is_part ? id_of(blocks, blocks.mover_of(slot)) : 0;
    if (part) *part = is_part ? blocks.compounds().index_in_compound(slot) : -1;
    return HS_OK;
  });
}
