#pragma once

#include <cstdint>
#include <utility>

#include "angular.h"
#include "context_handle.h"
#include "guard.h"
#include "halfspace/mesh.h"
#include "halfspace/world.h"
#include "require.h"
#include "world/world.h"

/// Members of handles of both dimensions. WorldHandle adds the world.
struct hs_world {
  hs_context* context;
  std::int32_t dimension;
};

namespace halfspace::capi {

/// Handle with its world.
template <int D>
struct WorldHandle : hs_world {
  WorldHandle(hs_context* owner, const WorldSettings<D>& settings)
      : hs_world{owner, D}, world(settings, &owner->memory, owner->threads.get(), &owner->interrupt) {}

  World<D> world;
};

inline hs_context* context_of(const hs_world* world) { return world ? world->context : nullptr; }

/// Calls use(world) with the World<2> or World<3> of the handle.
template <class Use>
auto visit(hs_world& handle, Use&& use) {
  return handle.dimension == 2 ? use(static_cast<WorldHandle<2>&>(handle).world)
                               : use(static_cast<WorldHandle<3>&>(handle).world);
}
template <class Use>
auto visit(const hs_world& handle, Use&& use) {
  return handle.dimension == 2 ? use(static_cast<const WorldHandle<2>&>(handle).world)
                               : use(static_cast<const WorldHandle<3>&>(handle).world);
}

/// The body of an entry point: guarded, calls use(world) with the World<2> or World<3> of the handle.
template <class Handle, class Use>
hs_status with_world(Handle* world, const char* function, Use&& use) {
  return guarded(context_of(world), function, [&] {
    require_pointer(world, "world");
    return visit(*world, use);
  });
}

/// An id holds the slot plus 1 (0 is no block) and the generation of the slot.
template <int D>
hs_block id_of(const Blocks<D>& blocks, std::size_t slot) {
  return (std::uint64_t(blocks.generation[slot]) << 32) | (slot + 1);
}

/// The slot of a living block.
template <int D>
std::int32_t slot_of(const Blocks<D>& blocks, hs_block id, const char* name) {
  const std::uint64_t slot = (id & 0xffffffffu) - 1;
  if (slot >= blocks.slot_count() || !blocks.lives(std::size_t(slot)) ||
      id_of(blocks, std::size_t(slot)) != id) {
    refuse(HS_ERROR_STALE_ID, "%s is %#llx; no living block has that id", name,
           static_cast<unsigned long long>(id));
  }
  return std::int32_t(slot);
}

/// Ids of bodies have the same format.
template <int D>
hs_body id_of(const Meshes<D>& meshes, std::int32_t body) {
  return (std::uint64_t(meshes.body(body).generation) << 32) | (std::uint64_t(body) + 1);
}

/// The index of an existing body.
template <int D>
std::int32_t body_of(const Meshes<D>& meshes, hs_body id, const char* name) {
  const std::uint64_t body = (id & 0xffffffffu) - 1;
  if (body >= meshes.bodies().size() || !meshes.body(std::int32_t(body)).lives ||
      id_of(meshes, std::int32_t(body)) != id) {
    refuse(HS_ERROR_STALE_ID, "%s is %#llx; no body has that id", name, static_cast<unsigned long long>(id));
  }
  return std::int32_t(body);
}

/// Visits the living blocks in the order of the block arrays.
template <int D, class Visitor>
void for_each_block(const Blocks<D>& blocks, Visitor&& visit) {
  std::int64_t i = 0;
  for (std::size_t slot = 0; slot < blocks.slot_count(); ++slot) {
    if (blocks.lives(slot)) visit(i++, std::int32_t(slot));
  }
}

/// Calls write(i, slot) for as many blocks as fit, and writes their number to `count`.
template <int D, class Write>
hs_status write_blocks(const Blocks<D>& blocks, std::int64_t capacity, std::int64_t* count, Write&& write) {
  for_each_block(blocks, [&](std::int64_t i, std::int32_t slot) {
    if (i < capacity) write(i, std::size_t(slot));
  });
  if (count) *count = blocks.count();
  return fits(blocks.count(), capacity);
}

/// Writes a vector and an angular vector per block into the host's views; the second view may be empty.
template <int D>
hs_status write_blocks(const Blocks<D>& blocks, const Array<Vector<D>>& vectors, const hs_mutable_view& out,
                       const Array<Angular<D>>& angulars, const hs_mutable_view& angular_out) {
  for_each_block(blocks, [&](std::int64_t i, std::int32_t slot) {
    if (i < out.count) write_point(out, i, vectors[std::size_t(slot)]);
    if (i < angular_out.count) write_angular(angular_out, i, angulars[std::size_t(slot)]);
  });
  const bool all_angulars = angular_out.count == 0 || angular_out.count >= blocks.count();
  return all_angulars ? fits(blocks.count(), out.count) : HS_NOTE_TRUNCATED;
}

/// Refuses a block that only the nodes of its mesh, or only its compound, can move.
template <int D>
void require_moved_by_itself(const Blocks<D>& blocks, std::int32_t slot, const char* name) {
  const auto id = [&](std::size_t s) { return static_cast<unsigned long long>(id_of(blocks, s)); };
  const std::size_t s = std::size_t(slot);
  if (blocks.is_of_mesh(s)) {
    refuse(HS_ERROR_STATE, "%s is %#llx, a block of a mesh; only its nodes can be changed", name, id(s));
  }
  if (blocks.is_part(s)) {
    refuse(HS_ERROR_STATE, "%s is %#llx, a part of compound %#llx; only the compound can be changed", name,
           id(s), id(blocks.mover_of(s)));
  }
}

/// Refuses a share of a larger world.
template <int D>
void require_whole(const World<D>& world, const char* advice) {
  if (!world.state().share.is_whole())
    refuse(HS_ERROR_STATE, "world is a share of a larger world; %s", advice);
}
/// Refuses a step in pieces that has not ended.
template <int D>
void require_between_steps(const World<D>& world) {
  const ShareStage stage = world.state().share.stage();
  if (stage == ShareStage::begun || stage == ShareStage::moved)
    refuse(HS_ERROR_STATE, "world is within a step; call %s first",
           stage == ShareStage::begun ? "hs_world_end_begin()" : "hs_world_end_step()");
}

/// Refuses a new list of pairs where copies may have rested since the last one.
template <int D>
void require_copies_in_place(const World<D>& world) {
  if (world.state().share.has_stale_copies() && !world.state().contacts.are_found() &&
      world.state().contacts.neighbors().needs_rebuild())
    refuse(HS_ERROR_STATE, "laws have changed since copies were brought; call hs_world_assemble() first");
}

/// The body of an entry point that changes the world: as with_world(), and refused within a step in pieces.
template <class Use>
hs_status with_world_between_steps(hs_world* world, const char* function, Use&& use) {
  return with_world(world, function, [&]<int D>(World<D>& w) {
    require_between_steps(w);
    return use(w);
  });
}

/// Refuses what only the whole world can do, between steps.
template <int D>
void require_joined(const World<D>& world) {
  require_whole(world, "join the shares with hs_world_assemble() first");
  require_between_steps(world);
}

template <int D>
void require_material(const World<D>& world, std::int32_t material, const ArgumentName& name) {
  if (material < 0 || material >= world.model().materials.count()) {
    refuse(HS_ERROR_STALE_ID, "%s is %d; the world has %d materials", NameText(name).characters, material,
           world.model().materials.count());
  }
}

}  // namespace halfspace::capi
