#pragma once

#include "require.h"
#include "world/world.h"

namespace halfspace::capi {

/// Refuses indices that are none of the nodes of a body.
template <int D>
void require_nodes(const Body<D>& body, const std::int32_t* nodes, std::int64_t count) {
  require_count(count, "count");
  if (count > 0) require_pointer(nodes, "nodes");
  for (std::int64_t i = 0; i < count; ++i) {
    if (nodes[i] < 0 || nodes[i] >= body.node_count) {
      refuse(HS_ERROR_ARGUMENT, "nodes[%lld] is %d; the body has %lld nodes", static_cast<long long>(i),
             nodes[i], static_cast<long long>(body.node_count));
    }
  }
}

}  // namespace halfspace::capi
