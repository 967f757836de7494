#pragma once

#include "world/snapshot.h"
#include "world_handle.h"

namespace halfspace::capi {

/// A copy of a world as its next step begins: with contacts, forces and time step after a change.
template <int D>
struct PreparedCopy {
  PreparedCopy(const hs_world& handle, const World<D>& of)
      : world(of.model().settings, &handle.context->memory, handle.context->threads.get()) {
    snapshot::copy_state(of, world);
    world.prepare();
  }

  World<D> world;
};

/// Calls query(world) with the world as its next step begins. After a change that is a copy, as queries
/// change nothing.
template <int D, class Query>
void query_prepared(const hs_world& handle, World<D>& world, Query query) {
  if (!world.state().is_edited()) return query(world);
  PreparedCopy<D> copy(handle, world);
  query(copy.world);
}

}  // namespace halfspace::capi
