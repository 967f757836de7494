#include "detect/support.h"

namespace halfspace {

/// Heights over a convex surface have one minimum: every vertex that is not the deepest has a deeper
/// neighbour.
Support walk_to_deepest(const Outline<3>& block, const Vector<3>& direction, int hint) {
  const Topology& topology = *block.topology;
  const auto height = [&](int v) {
    return direction.x() * block.x[v] + direction.y() * block.y[v] + direction.z() * block.z[v];
  };
  Support here{height(hint), hint};
  for (;;) {
    Support next = here;
    for (int k = topology.first_of_vertex[here.vertex]; k < topology.first_of_vertex[here.vertex + 1]; ++k) {
      const int neighbour = topology.vertex_neighbour[k];
      const double neighbours_height = height(neighbour);
      if (neighbours_height < next.height) next = {neighbours_height, neighbour};
    }
    if (next.vertex == here.vertex) return here;
    here = next;
  }
}

}  // namespace halfspace
