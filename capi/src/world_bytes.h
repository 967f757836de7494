#pragma once

#include <cstddef>
#include <span>

#include "world/snapshot.h"
#include "world_handle.h"

namespace halfspace::capi {

/// Creates a world from a state that write_state() has written; refuses other bytes.
template <int D>
WorldHandle<D>* restore(hs_context* context, std::span<const std::byte> state) {
  WorldHandle<D>* restored = create<WorldHandle<D>>(context, context, WorldSettings<D>());
  try {
    if (!snapshot::read_state(state, restored->world))
      refuse(HS_ERROR_FORMAT, "bytes do not hold a valid state of a world");
  } catch (...) {
    destroy(context, restored);
    throw;
  }
  return restored;
}

}  // namespace halfspace::capi
