#pragma once

#include <cstddef>
#include <span>

#include "world/snapshot.h"
#include "world_handle.h"

namespace halfspace::capi {

/// A new world of a state that write_state() gave; any other is refused.
template <int D>
WorldHandle<D>* restore(hs_context* context, std::span<const std::byte> state) {
  WorldHandle<D>* restored = create<WorldHandle<D>>(context, context, WorldSettings<D>());
  try {
    if (!snapshot::read_state(state, restored->world))
      refuse(HS_ERROR_FORMAT, "bytes do not hold what a snapshot holds");
  } catch (...) {
    destroy(context, restored);
    throw;
  }
  return restored;
}

}  // namespace halfspace::capi
