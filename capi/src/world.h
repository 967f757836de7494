#pragma once

#include <cstdint>

#include "check.h"
#include "context.h"
#include "guard.h"
#include "halfspace/world.h"
#include "world/world.h"

struct hs_world {
  hs_world(hs_context* owner, const halfspace::WorldSettings<2>& settings)
      : context(owner), world(settings, &owner->memory) {}

  hs_context* context;
  halfspace::World<2> world;
};

namespace halfspace::capi {

inline hs_context* context_of(const hs_world* world) { return world ? world->context : nullptr; }

/// Ids carry the slot, from 1 so that 0 is no block, and the slot's generation.
inline hs_block id_of(const Blocks<2>& blocks, std::size_t slot) {
  return (std::uint64_t(blocks.generation[slot]) << 32) | (slot + 1);
}

/// The slot of a living block.
inline std::int32_t slot_of(const Blocks<2>& blocks, hs_block id, const char* name) {
  const std::uint64_t slot = (id & 0xffffffffu) - 1;
  if (slot >= blocks.slot_count() || !blocks.lives(std::size_t(slot)) ||
      id_of(blocks, std::size_t(slot)) != id) {
    refuse(HS_ERROR_STALE_ID, "%s is %#llx; no living block has that id", name,
           static_cast<unsigned long long>(id));
  }
  return std::int32_t(slot);
}

/// Visits the living blocks in the order of the block arrays.
template <class Visitor>
void for_each_block(const Blocks<2>& blocks, Visitor&& visit) {
  std::int64_t i = 0;
  for (std::size_t slot = 0; slot < blocks.slot_count(); ++slot) {
    if (blocks.lives(slot)) visit(i++, std::int32_t(slot));
  }
}

inline Vector<2> read_finite_vector(const double* values, const char* name) {
  require_pointer(values, name);
  for (int i = 0; i < 2; ++i) {
    if (!std::isfinite(values[i])) {
      refuse(HS_ERROR_ARGUMENT, "%s[%d] is %g; it must be finite", name, i, values[i]);
    }
  }
  return {values[0], values[1]};
}

/// The z of a spin or torque.
inline Angular<2> read_finite_turn(const double* values, const char* name) {
  require_pointer(values, name);
  if (!std::isfinite(values[2])) refuse(HS_ERROR_ARGUMENT, "%s[2] is %g; it must be finite", name, values[2]);
  return Angular<2>(values[2]);
}

}  // namespace halfspace::capi
