#include "geometry/support.h"

#include <algorithm>

namespace halfspace {
namespace {

Support support_at(const Outline<3>& block, const Vector<3>& direction, int v) {
  return {direction.x() * block.x[v] + direction.y() * block.y[v] + direction.z() * block.z[v], v};
}

/// Without branches, as they would be unpredictable.
Support deeper(const Support& s, const Support& t) {
  return {std::min(s.height, t.height), t.height < s.height ? t.vertex : s.vertex};
}

Support walk_from(const Outline<3>& block, const Vector<3>& direction, Support here) {
  const Topology& topology = *block.topology;
  for (;;) {
    Support next = here;
    for (int k = topology.first_of_vertex[here.vertex]; k < topology.first_of_vertex[here.vertex + 1]; ++k)
      next = deeper(next, support_at(block, direction, topology.vertex_neighbour[k]));
    if (next.vertex == here.vertex) return here;
    here = next;
  }
}

}  // namespace

/// On a convex surface every vertex except the deepest has a deeper neighbour.
Support walk_to_deepest(const Outline<3>& block, const Vector<3>& direction, int hint) {
  return walk_from(block, direction, support_at(block, direction, hint));
}

Support walk_to_deepest(const Outline<3>& block, const Vector<3>& direction) {
  constexpr int tried = 16;
  const int stride = (block.vertex_count() + tried - 1) / tried;
  Support start = support_at(block, direction, 0);
  for (int v = stride; v < block.vertex_count(); v += stride)
    start = deeper(start, support_at(block, direction, v));
  return walk_from(block, direction, start);
}

}  // namespace halfspace
