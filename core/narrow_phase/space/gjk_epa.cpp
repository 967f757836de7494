#include "narrow_phase/space/gjk_epa.h"

#include <cmath>
#include <utility>

#include "geometry/rotation.h"
#include "geometry/tolerances.h"
#include "narrow_phase/space/epa.h"
#include "narrow_phase/space/pair.h"
#include "narrow_phase/space/potential_pairs.h"
#include "narrow_phase/space/simplex.h"

// GJK moves a simplex of corners of the Minkowski difference b - a towards the origin, EPA expands it from
// there:
//
//   corner <- support of the difference towards the origin
//   repeat: the corner does not pass the origin? then that direction is a plane between the blocks
//           add the corner to the simplex, and keep its face nearest to the origin
//   the origin is inside: expand the nearest facet by its support, until the support is in the facet
//
// The last facet gives features of both blocks: a face and a vertex, or two edges. The result is the gap of
// these features, independent of the polytope. If the facet does not prove it, neighbouring features are
// tested until none has a smaller depth.

namespace halfspace {
namespace {

/// The plane between separated blocks, with their deepest vertices as its pair.
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

/// The last facet of the polytope.
struct FoundFacet {
  Vector<3> normal;  // unit, from a to b
  Corner corner;     // a corner on its plane
  bool is_proven;    // no corner of the difference is deeper

  /// Is the corner also the deepest along a unit normal that equals the facet's to rounding? Any other is
  /// deeper by at most this fraction of the difference's size.
  bool is_corner_deepest_along(const Vector<3>& other) const {
    constexpr double rounding = 64 * machine_epsilon;
    return is_proven && (other - normal).squaredNorm() <= rounding * rounding;
  }
};

/// A face of block a at the facet, and the deepest vertex of b behind it.
template <class Turn>
Separation<3> at_face_of_a(const MinkowskiDifference<Turn>& difference, const FoundFacet& facet) {
  const Outline<3>&a = difference.a(), &b = difference.b();
  const Corner& near = facet.corner;
  const int face = face_along(a, near.a, facet.normal);
  const Vector<3> normal = a.normal(face);
  const int vertex = facet.is_corner_deepest_along(normal)
                         ? near.b
                         : deepest(b, difference.in_frame_of_b(normal), near.b).vertex;
  return {normal.dot(difference.vertex_of_b(vertex)) - a.offset[face],
          {PotentialPair<3>::face_vertex, face, vertex},
          normal};
}

/// A face of block b at the facet, and the deepest vertex of a behind it.
template <class Turn>
Separation<3> at_face_of_b(const MinkowskiDifference<Turn>& difference, const FoundFacet& facet) {
  const Outline<3>&a = difference.a(), &b = difference.b();
  const Corner& near = facet.corner;
  const int face = face_along(b, near.b, difference.in_frame_of_b(-facet.normal));
  const Vector<3> normal = -difference.normal_of_b(face);
  const int vertex = facet.is_corner_deepest_along(normal) ? near.a : deepest(a, -normal, near.a).vertex;
  return {normal.dot(difference.to_b() - a.vertex(vertex)) - b.offset[face],
          {PotentialPair<3>::vertex_face, vertex, face},
          normal};
}

/// An edge of each block at the facet. The gap is -infinity when they are all but parallel.
template <class Turn>
Separation<3> at_edges(const MinkowskiDifference<Turn>& difference, const FoundFacet& facet, int edge_of_a,
                       int edge_of_b) {
  const PotentialPair<3> pair{PotentialPair<3>::edge_edge, edge_of_a, edge_of_b};
  const Vector<3> along_b = difference.from_frame_of_b(edge_vector(difference.b(), edge_of_b));
  if (are_all_but_parallel(edge_vector(difference.a(), edge_of_a), along_b))
    return {-HUGE_VAL, pair, Vector<3>::Zero()};
  const Vector<3> normal = edge_pair_normal(difference.a(), edge_of_a, along_b);
  const Corner deepest =
      facet.is_corner_deepest_along(normal) ? facet.corner : difference.deepest_along(normal, facet.corner);
  return {normal.dot(deepest.at), pair, normal};
}

/// The vertices of one block in a facet's corners: one, two of an edge, or three of a face.
struct FacetVertices {
  int first;
  int second;  // different from the first, if any
  int count;

  FacetVertices(int i, int j, int k)
      : first(i), second(j != i ? j : k), count(1 + (j != i) + (k != i && k != j)) {}
};

/// Are both faces at an edge oblique to a direction? If not, a face may lie in the plane and has priority.
bool is_sharp(const Outline<3>& block, int edge, const Vector<3>& along) {
  const Topology& topology = *block.topology;
  return block.normal(topology.edge_left[edge]).dot(along) < in_plane_cosine &&
         block.normal(topology.edge_right[edge]).dot(along) < in_plane_cosine;
}

/// The potential pair of the facet with three given corners: a face of either block at those vertices, or an
/// edge of each. If several share the plane, the one of largest gap.
template <class Turn, class Polytope>
Separation<3> pair_at(const MinkowskiDifference<Turn>& difference, const Polytope& polytope, bool is_proven) {
  const Outline<3>&a = difference.a(), &b = difference.b();
  const Corner c = polytope.corner_of_nearest(0), d = polytope.corner_of_nearest(1),
               e = polytope.corner_of_nearest(2);
  const PolytopeFacet nearest = polytope.nearest();
  const FoundFacet facet{-nearest.normal, e, is_proven};
  const double rounding = polytope.rounding();
  const auto is_as_deep = [&](const Separation<3>& found) { return found.gap >= -nearest.offset - rounding; };

  // Usually the corners identify the features.
  const FacetVertices of_a(c.a, d.a, e.a), of_b(c.b, d.b, e.b);
  if (of_b.count == 1) {
    const Separation<3> face_of_a = at_face_of_a(difference, facet);
    if (is_as_deep(face_of_a)) return face_of_a;
  }
  if (of_a.count == 1) {
    const Separation<3> face_of_b = at_face_of_b(difference, facet);
    if (is_as_deep(face_of_b)) return face_of_b;
  }
  const int edge_of_a = of_a.count == 1 ? -1 : edge_between(*a.topology, of_a.first, of_a.second);
  const int edge_of_b = of_b.count == 1 ? -1 : edge_between(*b.topology, of_b.first, of_b.second);
  Separation<3> edges{-HUGE_VAL, {}, facet.normal};
  if (edge_of_a >= 0 && edge_of_b >= 0) {
    edges = at_edges(difference, facet, edge_of_a, edge_of_b);
    if (is_sharp(a, edge_of_a, facet.normal) &&
        is_sharp(b, edge_of_b, difference.in_frame_of_b(-facet.normal)) && is_as_deep(edges))
      return edges;
  }

  // Where a face is parallel to a feature of the other block, several pairs share the plane.
  const Separation<3> face_of_a = at_face_of_a(difference, facet);
  const Separation<3> face_of_b = at_face_of_b(difference, facet);
  const Separation<3>& face = face_of_b.gap > face_of_a.gap ? face_of_b : face_of_a;
  return edges.gap > face.gap + rounding ? edges : face;
}

/// Completes a simplex with the origin on its boundary to a tetrahedron, unless the difference is flat.
template <class Turn>
void complete(const MinkowskiDifference<Turn>& difference, Simplex& simplex) {
  const Vector<3> first = simplex.corner[0].at;
  const auto take = [&](const Vector<3>& direction) {
    for (const double sense : {1.0, -1.0}) {
      const Corner c = difference.deepest_along(sense * direction, simplex.corner[0]);
      if (direction.dot(c.at - first) == 0 || simplex.has(c)) continue;
      simplex.corner[simplex.count++] = c;
      return true;
    }
    return false;
  };
  const auto from_first = [&](int i) { return Vector<3>(simplex.corner[i].at - first); };
  if (simplex.count == 1 && !take({1, 0, 0})) take({0, 1, 0});
  if (simplex.count == 2) {
    const Vector<3> along = from_first(1);
    int least = 0;
    along.cwiseAbs().minCoeff(&least);
    const Vector<3> across = cross_product(along, Vector<3>::Unit(least));
    if (!take(across)) take(cross_product(along, across));
  }
  if (simplex.count == 3) take(cross_product(from_first(1), from_first(2)));
}

/// GJK: moves a simplex towards the origin until a plane separates them. If none does, the simplex ends as a
/// tetrahedron around the origin, or with fewer corners when the difference is flat.
template <class Four, class Turn>
[[gnu::always_inline]] inline bool is_behind_plane(const MinkowskiDifference<Turn>& difference,
                                                   Separation<3>& plane, Simplex& simplex) {
  Vector<3> direction = difference.to_b();
  if (direction.squaredNorm() == 0) direction = {1, 0, 0};  // the length may underflow
  double distance = HUGE_VAL;
  Corner c = difference.template deepest_along<Four>(direction);
  for (;;) {
    if (direction.dot(c.at) > 0) {
      plane = between(c, direction);
      return true;
    }
    // A corner found before brings the simplex no nearer: it touches the origin, to rounding.
    if (simplex.has(c)) break;
    simplex.add(c);
    direction = simplex.nearest;
    const double before = std::exchange(distance, direction.squaredNorm());
    if (!(distance > 0 && distance < before)) break;
    c = difference.template deepest_along<Four>(direction, c);
  }
  if (simplex.count < 4) complete(difference, simplex);
  return false;
}

/// The pair of smallest depth among the given one and those of all faces.
template <class Turn>
Separation<3> shallowest_of_faces(const MinkowskiDifference<Turn>& difference, const Separation<3>& found) {
  const SeenOutline a = difference.a(), b = difference.seen_b();
  Separation<3> best = found;
  const auto look_at = [&](PotentialPair<3> pair) {
    const double gap = refresh(a, b, difference.to_b(), pair);
    if (gap > best.gap) best = {gap, pair, normal_of(a, b, pair)};
  };
  for (int face = 0; face < a.topology->face_count; ++face) look_at({PotentialPair<3>::face_vertex, face, 0});
  for (int face = 0; face < b.topology->face_count; ++face) look_at({PotentialPair<3>::vertex_face, 0, face});
  return best;
}

/// Walks to the neighbouring pair of smallest depth, repeatedly, where the polytope is not a proof. The
/// normals of its triangles may be wrong for slivers, and its number of corners is limited; the normals here
/// are those of the blocks' own features.
template <class Turn>
Separation<3> refined(const MinkowskiDifference<Turn>& difference, const Separation<3>& found) {
  const SeenOutline a = difference.a(), b = difference.seen_b();
  Separation<3> best = found;
  for (int moves = a.topology->edge_count + b.topology->edge_count; moves > 0; --moves) {
    const Separation<3> here = best;
    for_each_side(a, b, here.pair, [&](const FacetSide& side) {
      PotentialPair<3> pair = facet_across(a, b, side, here.normal).pair;
      const double gap = refresh(a, b, difference.to_b(), pair);
      if (gap > best.gap) best = {gap, pair, normal_of(a, b, pair)};
    });
    if (best.pair == here.pair) break;
  }
  return best;
}

/// EPA, for blocks without a separating plane. Where rounding has hidden one, the gap may be positive.
template <class Four, class Turn>
[[gnu::always_inline]] inline Separation<3> min_depth(const MinkowskiDifference<Turn>& difference,
                                                      const Simplex& around_origin) {
  ExpandingPolytope<Four> polytope(around_origin.corner);
  for (;;) {
    const Corner c =
        difference.template deepest_along<Four>(-polytope.normal_of_nearest(), polytope.corner_of_nearest(0));
    const bool is_facet = polytope.is_behind_nearest(c.at);
    if (is_facet || !polytope.expand(c)) {
      const Separation<3> found = pair_at(difference, polytope, is_facet);
      const bool is_final = is_facet && found.gap <= -sliver_rounding * polytope.rounding();
      if (is_final) return found;
      // The walk is local: among many sides of nearly the same depth, the minimum may be far away.
      return refined(difference, is_facet ? found : shallowest_of_faces(difference, found));
    }
  }
}

/// For blocks that are flat in one plane, to rounding, and touch there: a polytope would have no volume.
/// Starts from any face.
template <class Turn>
Separation<3> min_depth_of_flat(const MinkowskiDifference<Turn>& difference, const Simplex& flat) {
  const FoundFacet facet{flat.nearest, flat.corner[0], false};
  return refined(difference, at_face_of_a(difference, facet));
}

}  // namespace

template <class Turn>
Separation<3> find_separation_by_descent(const MinkowskiDifference<Turn>& difference) {
  return with_widest_lanes([&]<class Four>() {
    Separation<3> plane;
    Simplex simplex;
    if (is_behind_plane<Four>(difference, plane, simplex)) return plane;
    return simplex.count == 4 ? min_depth<Four>(difference, simplex) : min_depth_of_flat(difference, simplex);
  });
}

template Separation<3> find_separation_by_descent(const MinkowskiDifference<NoTurn>&);
template Separation<3> find_separation_by_descent(const MinkowskiDifference<Rotation<3>>&);

}  // namespace halfspace
