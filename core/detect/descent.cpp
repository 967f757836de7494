#include "detect/descent.h"

#include <cmath>
#include <utility>

#include "detect/potential_pairs_3d.h"
#include "geometry/rotation.h"

namespace halfspace {
namespace {

/// The plane between blocks that are apart: a half-space of which block only its own deepest vertices are
/// known.
Separation<3> between(const Corner& deepest, const Vector<3>& direction) {
  const double length = direction.norm();
  return {direction.dot(deepest.at) / length,
          {PotentialPair<3>::vertex_vertex, deepest.a, deepest.b},
          direction / length};
}

/// The edge between two vertices, or -1.
int edge_between(const Topology& topology, int from, int to) {
  for (int k = topology.first_of_vertex[from]; k < topology.first_of_vertex[from + 1]; ++k) {
    if (topology.vertex_neighbour[k] == to) return topology.vertex_edge[k];
  }
  return -1;
}

/// The edge that the corners of a facet have on one block when they have two vertices there.
template <class VertexOf>
int edge_of_facet(const Topology& topology, const Corner* c, VertexOf vertex_of) {
  const int first = vertex_of(c[0]);
  const int second = vertex_of(c[1]) != first ? vertex_of(c[1]) : vertex_of(c[2]);
  return second == first ? -1 : edge_between(topology, first, second);
}

/// The potential pair whose facet of the Minkowski difference holds three corners, seen along its `normal`
/// from a to b: a face of either block at the vertices found, or an edge of each; the one of largest gap.
template <class Turn>
Separation<3> pair_at(MinkowskiDifference<Turn>& difference, const Corner* c, const Vector<3>& normal,
                      double rounding) {
  const Outline<3>&a = difference.a(), &b = difference.b();
  const int face_of_a = face_along(a, c[0].a, normal);
  const Vector<3> normal_a = a.normal(face_of_a);
  const Corner behind_a = difference.deepest_along(normal_a);
  Separation<3> best{normal_a.dot(difference.vertex_of_b(behind_a.b)) - a.offset[face_of_a],
                     {PotentialPair<3>::face_vertex, face_of_a, behind_a.b},
                     normal_a};

  const int face_of_b = face_along(b, c[0].b, difference.in_frame_of_b(-normal));
  const Vector<3> normal_b = -difference.normal_of_b(face_of_b);
  const Corner behind_b = difference.deepest_along(normal_b);
  const double gap_b = normal_b.dot(difference.to_b() - a.vertex(behind_b.a)) - b.offset[face_of_b];
  if (gap_b > best.gap) best = {gap_b, {PotentialPair<3>::vertex_face, behind_b.a, face_of_b}, normal_b};

  const int edge_of_a = edge_of_facet(*a.topology, c, [](const Corner& corner) { return corner.a; });
  const int edge_of_b = edge_of_facet(*b.topology, c, [](const Corner& corner) { return corner.b; });
  if (edge_of_a < 0 || edge_of_b < 0) return best;
  const Vector<3> along_a =
      a.vertex(a.topology->edge_end[edge_of_a]) - a.vertex(a.topology->edge_start[edge_of_a]);
  const Vector<3> along_b = difference.vertex_of_b(b.topology->edge_end[edge_of_b]) -
                            difference.vertex_of_b(b.topology->edge_start[edge_of_b]);
  Vector<3> across = cross_product(along_a, along_b);
  const double length = across.norm();
  if (length == 0) return best;
  across /= across.dot(normal) < 0 ? -length : length;
  const double gap = across.dot(difference.deepest_along(across).at);
  if (gap > best.gap + rounding) best = {gap, {PotentialPair<3>::edge_edge, edge_of_a, edge_of_b}, across};
  return best;
}

/// Grows a simplex that holds the origin on its boundary into a tetrahedron. False when the difference is
/// flat.
template <class Turn>
bool complete(MinkowskiDifference<Turn>& difference, Simplex& simplex) {
  const auto take = [&](const Vector<3>& direction) {
    for (const double sense : {1.0, -1.0}) {
      const Corner c = difference.deepest_along(sense * direction);
      if (direction.dot(c.at - simplex.corner[0].at) == 0 || simplex.has(c)) continue;
      simplex.corner[simplex.count++] = c;
      return true;
    }
    return false;
  };
  const auto from_first = [&](int i) { return Vector<3>(simplex.corner[i].at - simplex.corner[0].at); };
  const auto least_axis = [](const Vector<3>& v) {
    int axis = 0;
    v.cwiseAbs().minCoeff(&axis);
    return Vector<3>(Vector<3>::Unit(axis));
  };
  if (simplex.count == 1 && !take({1, 0, 0}) && !take({0, 1, 0})) return false;
  if (simplex.count == 2) {
    const Vector<3> along = from_first(1), first = cross_product(along, least_axis(along));
    if (!take(first) && !take(cross_product(along, first))) return false;
  }
  return simplex.count == 4 || take(cross_product(from_first(1), from_first(2)));
}

/// Of blocks that overlap.
template <class Turn>
Separation<3> least_depth(MinkowskiDifference<Turn>& difference, const Simplex& around_origin) {
  ExpandingPolytope polytope(around_origin.corner);
  for (;;) {
    const ExpandingPolytope::Facet& facet = polytope.nearest();
    const Corner c = difference.deepest_along(-facet.normal);
    const bool is_facet = facet.normal.dot(c.at) - facet.offset <= polytope.rounding();
    if (is_facet || !polytope.has_room()) {
      const Corner corners[] = {polytope.corner(facet.corner[0]), polytope.corner(facet.corner[1]),
                                polytope.corner(facet.corner[2])};
      return pair_at(difference, corners, -facet.normal, polytope.rounding());
    }
    polytope.expand(c);
  }
}

}  // namespace

template <class Turn>
Separation<3> find_separation_by_descent(MinkowskiDifference<Turn> difference) {
  Simplex simplex;
  Vector<3> direction = difference.to_b();
  if (direction == Vector<3>::Zero()) direction = {1, 0, 0};
  double distance = HUGE_VAL;
  while (simplex.count < 4) {
    const Corner c = difference.deepest_along(direction);
    if (direction.dot(c.at) > 0) return between(c, direction);
    // What has been found before brings the simplex no nearer: it touches the origin, to rounding.
    if (simplex.has(c)) break;
    simplex.add(c);
    direction = simplex.nearest;
    const double before = std::exchange(distance, direction.squaredNorm());
    if (!(distance > 0 && distance < before)) break;
  }
  if (simplex.count < 4) complete(difference, simplex);
  return least_depth(difference, simplex);
}

template Separation<3> find_separation_by_descent(MinkowskiDifference<NoTurn>);
template Separation<3> find_separation_by_descent(MinkowskiDifference<Rotation<3>>);

}  // namespace halfspace
