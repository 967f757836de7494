#pragma once

#include <cstddef>
#include <span>

#include "world/snapshot.h"
#include "world_handle.h"

namespace halfspace::capi {

/// Writes the state of a world or of a part of it, or without a place only counts. One visit() serves reading
/// and writing. Returns the number of bytes.
template <class Part>
std::size_t write_state(const Part& part, std::byte* out) {
  snapshot::Writer writer(out);
  const_cast<Part&>(part).visit(writer);
  return writer.size();
}

template <class Part>
std::size_t state_size(const Part& part) {
  return write_state(part, nullptr);
}

/// A new world of a state that write_state() gave; any other is refused.
template <int D>
WorldHandle<D>* restore(hs_context* context, std::span<const std::byte> state) {
  WorldHandle<D>* restored = create<WorldHandle<D>>(context, context, WorldSettings<D>());
  try {
    snapshot::Reader reader(state);
    restored->world.visit(reader);
    if (reader.failed() || !reader.at_end() || !restored->world.is_consistent())
      refuse(HS_ERROR_FORMAT, "bytes do not hold what a snapshot holds");
    restored->world.fit_rooms();
  } catch (...) {
    destroy(context, restored);
    throw;
  }
  return restored;
}

}  // namespace halfspace::capi
