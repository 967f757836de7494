#include "narrow_phase/space/potential_pairs.h"

#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"

namespace halfspace {
namespace {

/// Rounding error of the height difference of two vertices along a unit normal.
double rounding_between(const Vector<3>& from, const Vector<3>& to) {
  return 4 * machine_epsilon * (from.cwiseAbs().maxCoeff() + to.cwiseAbs().maxCoeff());
}

PotentialPair<3> face_pair(int owner, int face, int vertex) {
  return owner == 0 ? PotentialPair<3>{PotentialPair<3>::face_vertex, face, vertex}
                    : PotentialPair<3>{PotentialPair<3>::vertex_face, vertex, face};
}

PotentialPair<3> edge_pair(int owner, int edge, int edge_of_other) {
  return owner == 0 ? PotentialPair<3>{PotentialPair<3>::edge_edge, edge, edge_of_other}
                    : PotentialPair<3>{PotentialPair<3>::edge_edge, edge_of_other, edge};
}

}  // namespace

int face_along(const SeenOutline& block, int vertex, const Vector<3>& direction) {
  const Topology& topology = *block.topology;
  int best = topology.vertex_face[topology.first_of_vertex[vertex]];
  double most = -HUGE_VAL;
  for (int k = topology.first_of_vertex[vertex]; k < topology.first_of_vertex[vertex + 1]; ++k) {
    const int face = topology.vertex_face[k];
    const double along = block.normal(face).dot(direction);
    if (along > most) {
      most = along;
      best = face;
    }
  }
  return best;
}

FacetSide side_along(const Topology& owner_topology, int owner, int face, int edge, int vertex) {
  const int left = owner_topology.edge_left[edge];
  return {owner, edge, left == face ? owner_topology.edge_right[edge] : left, vertex};
}

FacetSide side_at_end(const SeenOutline& owner_block, int owner, int edge, const SeenOutline& other,
                      int ending, int vertex) {
  const Topology& topology = *other.topology;
  const int start = topology.edge_start[ending], end = topology.edge_end[ending];
  const Vector<3> to_other_end = other.vertex(vertex == start ? end : start) - other.vertex(vertex);
  const int left = owner_block.topology->edge_left[edge], right = owner_block.topology->edge_right[edge];
  // Towards the face behind which this end of the other edge is deeper.
  const bool turns_left =
      to_other_end.dot(owner_block.normal(left)) >= to_other_end.dot(owner_block.normal(right));
  return {owner, edge, turns_left ? left : right, vertex};
}

Facet facet_across(const SeenOutline& a, const SeenOutline& b, const FacetSide& side,
                   const Vector<3>& normal) {
  const SeenOutline& owner = side.owner == 0 ? a : b;
  const SeenOutline& other = side.owner == 0 ? b : a;
  const Topology& topology = *other.topology;
  const Vector<3> from = side.owner == 0 ? normal : Vector<3>(-normal);
  const Vector<3> to = owner.normal(side.towards);
  const Vector<3> vertex = other.vertex(side.vertex), along = edge_vector(owner, side.edge);

  // The normal on the path is from + share * (to - from), normalized.
  double share = 1;
  int edge_reached = -1;
  for (int k = topology.first_of_vertex[side.vertex]; k < topology.first_of_vertex[side.vertex + 1]; ++k) {
    const Vector<3> neighbour = other.vertex(topology.vertex_neighbour[k]), edge = neighbour - vertex;
    const double climb = std::max(0.0, from.dot(edge));
    const double climb_at_end = to.dot(edge);
    if (climb_at_end >= -rounding_between(vertex, neighbour)) continue;
    // An edge that stays nearly in the plane is parallel to the side's edge, and has no plane.
    if (are_all_but_parallel(along, edge)) continue;
    const double reached_at = climb / (climb - climb_at_end);
    if (reached_at >= share) continue;
    share = reached_at;
    edge_reached = topology.vertex_edge[k];
  }
  const Vector<3> reached = edge_reached < 0 ? to : (from + share * (to - from)).normalized();
  return {edge_reached < 0 ? face_pair(side.owner, side.towards, side.vertex)
                           : edge_pair(side.owner, side.edge, edge_reached),
          side.owner == 0 ? reached : Vector<3>(-reached)};
}

}  // namespace halfspace
