#pragma once

// A small world to be cut into shares.

#include "shares/compare.h"

namespace halfspace_test {

/// Four boxes in a row on a floor, with a given step.
struct Row {
  Context context = make_context();
  World world;
  std::vector<hs_block> boxes;

  explicit Row(hs_world_def def = world_def(), const hs_law_def& law = law_def(1e8, 0.5)) {
    if (def.time_step == 0) def.time_step = 1e-5;
    world = make_world(context.get(), def);
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 2000, &material), context.get());
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
    add_block(context.get(), world.get(), box(-9, -1, 9, 0), HS_BLOCK_FIXED);
    for (int i = 0; i < 4; ++i)
      boxes.push_back(add_block(context.get(), world.get(), box(i, 0, i + 1, 1), HS_BLOCK_RIGID));
  }

  hs_status assemble(const std::vector<hs_packed>& blocks, World* made = nullptr) const {
    hs_world* share = nullptr;
    const hs_status status =
        hs_world_assemble(context.get(), world.get(), blocks.data(), std::int64_t(blocks.size()), &share);
    World owner(share);
    if (made) *made = std::move(owner);
    return status;
  }
  std::string error() const { return hs_context_last_error(context.get()); }
};

inline hs_packed part(std::int64_t key, std::int32_t role) { return {key, nullptr, 0, role, 0}; }

/// Its first two boxes, and a copy of the third.
inline const std::vector<hs_packed> left = {part(0, HS_ROLE_EVERYWHERE), part(1, HS_ROLE_OWN),
                                            part(2, HS_ROLE_OWN), part(3, HS_ROLE_NEIGHBOR)};

}  // namespace halfspace_test
