#include "detect/edge_pairs.h"

#include <bit>
#include <cmath>

#include "detect/potential_pairs_3d.h"
#include "detect/support.h"

namespace halfspace {
namespace {

using EdgeSet = std::uint64_t;

/// Directions of a block's edges, from start to end, read two at a time.
struct EdgeDirections {
  double x[most_edges_in_set];
  double y[most_edges_in_set];
  double z[most_edges_in_set];

  explicit EdgeDirections(const Outline<3>& block) {
    const int count = block.topology->edge_count;
    for (int e = 0; e < count; ++e) {
      const Vector<3> direction = edge_vector(block, e);
      x[e] = direction.x();
      y[e] = direction.y();
      z[e] = direction.z();
    }
    if (count % 2 == 1) x[count] = y[count] = z[count] = 0;
  }

  Vector<3> operator[](int e) const { return {x[e], y[e], z[e]}; }
};

/// For each edge of a block, the other block's edges that cross from one of its two faces to the other in the
/// sense of THEORY section 2: `falling` those that descend along the outer normal of the face on its left and
/// climb along that on its right, `rising` the others that cross.
struct CrossingEdges {
  EdgeSet falling[most_edges_in_set];
  EdgeSet rising[most_edges_in_set];

  /// The sign of each (edge, face) is computed once.
  CrossingEdges(const Outline<3>& block, const EdgeDirections& others, int other_count) {
    constexpr int most_faces =
        2 * most_edges_in_set / 3;   // each has three edges at least, each edge two faces
    EdgeSet descending[most_faces];  // the other's edges, along each face's normal
    const Topology& topology = *block.topology;
    for (int f = 0; f < topology.face_count; ++f) {
      const TwoLanes nx = both(block.nx[f]), ny = both(block.ny[f]), nz = both(block.nz[f]);
      EdgeSet set = 0;
      for (int e = 0; e < other_count; e += 2) {
        const TwoLanes climb =
            two_at(others.x + e) * nx + two_at(others.y + e) * ny + two_at(others.z + e) * nz;
        set |= EdgeSet(signs(climb)) << e;
      }
      descending[f] = set;
    }
    for (int e = 0; e < topology.edge_count; ++e) {
      const EdgeSet left = descending[topology.edge_left[e]], right = descending[topology.edge_right[e]];
      falling[e] = left & ~right;
      rising[e] = right & ~left;
    }
  }
};

}  // namespace

/// By the four signs of edge direction and face normal (THEORY section 2): edges a and b make a facet of the
/// Minkowski difference when b crosses between the faces of a and a between those of b, in the same sense.
void judge_edge_pairs(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, Separation<3>& best) {
  const EdgeDirections edges_of_a(a), edges_of_b(b);
  const int count_a = a.topology->edge_count, count_b = b.topology->edge_count;
  const CrossingEdges across_a(a, edges_of_b, count_b), across_b(b, edges_of_a, count_a);

  /// Outward of a is a x b where both rise, b x a where both fall. True when the pair is violated.
  const auto judge = [&](int i, int j, double sense) {
    const Vector<3> normal = cross_product(edges_of_a[i], sense * edges_of_b[j]);
    const Vector<3> across =
        (b.vertex(b.topology->edge_start[j]) + to_b) - a.vertex(a.topology->edge_start[i]);
    const double length = normal.norm();
    if (!(normal.dot(across) > best.gap * length)) return false;
    // The normal of edges that are all but parallel is rounded as much as they are: what both blocks reach
    // along it is a proof all the same.
    const Vector<3> unit = normal / length;
    const double gap =
        (deepest_among_all(b, unit).height + deepest_among_all(a, -unit).height) + unit.dot(to_b);
    if (gap > best.gap) best = {gap, {PotentialPair<3>::edge_edge, i, j}, unit};
    return best.gap > 0;
  };
  for (int i = 0; i < count_a; ++i) {
    const EdgeSet self = EdgeSet(1) << i;
    for (EdgeSet left = across_a.falling[i]; left != 0; left &= left - 1) {
      const int j = std::countr_zero(left);
      if ((across_b.falling[j] & self) && judge(i, j, -1)) return;
    }
    for (EdgeSet left = across_a.rising[i]; left != 0; left &= left - 1) {
      const int j = std::countr_zero(left);
      if ((across_b.rising[j] & self) && judge(i, j, 1)) return;
    }
  }
}

}  // namespace halfspace
