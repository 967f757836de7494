#pragma once

#include <cmath>

#include "narrow_phase/contact.h"
#include "narrow_phase/space/seen_outline.h"

namespace halfspace {

/// From the start of an edge to its end.
inline Vector<3> edge_vector(const SeenOutline& block, int edge) {
  return block.vertex(block.topology->edge_end[edge]) - block.vertex(block.topology->edge_start[edge]);
}

/// The face at a vertex that looks most along a direction.
int face_along(const SeenOutline& block, int vertex, const Vector<3>& direction);

/// An edge of a block and the outer normals of the faces at it: read once, and asked often.
struct SeenEdge {
  Vector<3> start;
  Vector<3> along;  // from its start to its end
  Vector<3> left;
  Vector<3> right;

  template <class Block>
  SeenEdge(const Block& block, int edge)
      : start(block.vertex(block.topology->edge_start[edge])),
        along(block.vertex(block.topology->edge_end[edge]) - start),
        left(block.normal(block.topology->edge_left[edge])),
        right(block.normal(block.topology->edge_right[edge])) {}
};

/// True when a block lies behind the plane through one of its edges whose outer normal, at right angles to
/// the edge, is given.
inline bool is_outer_normal(const SeenEdge& edge, const Vector<3>& normal) {
  // Both point from the edge into its face.
  const Vector<3> into_left = cross_product(edge.left, edge.along);
  const Vector<3> into_right = cross_product(edge.along, edge.right);
  return normal.dot(into_left) <= 0 && normal.dot(into_right) <= 0;
}

/// Are two edges parallel but for an angle that is far above rounding and far below one that matters? The
/// normal of what they span is next to nothing but rounding, and their facet of the Minkowski difference a
/// sliver.
inline bool are_all_but_parallel(double square_of_cross_product, double square_a, double square_b) {
  constexpr double flat = 1e-6;  // rad
  return square_of_cross_product <= flat * flat * square_a * square_b;
}

/// The parallelogram of an edge of each block.
struct Parallelogram {
  Vector<3> across;  // at right angles to both edges, as long as the area is large
  double square;     // of the area
  double sense;      // 1 or, where the edge of a turns clockwise about `normal` towards that of b, -1

  Parallelogram(const SeenEdge& a, const Vector<3>& along_b)
      : across(cross_product(a.along, along_b)),
        square(across.squaredNorm()),
        sense(across.dot(a.left + a.right) < 0 ? -1 : 1) {}

  /// The normal has unit length and points out of a as the faces at a's edge do: for an edge-edge potential
  /// pair it is the normal from a to b. It is zero when the edges are exactly parallel.
  Vector<3> normal() const {
    const double area = std::sqrt(square);
    return (area == 0 ? 0 : sense / area) * across;
  }
};

/// The normal alone.
inline Vector<3> edge_pair_normal(const SeenOutline& a, int edge_of_a, const Vector<3>& along_b) {
  return Parallelogram(SeenEdge(a, edge_of_a), along_b).normal();
}
inline Vector<3> edge_pair_normal(const SeenOutline& a, int edge_of_a, const SeenOutline& b, int edge_of_b) {
  return edge_pair_normal(a, edge_of_a, edge_vector(b, edge_of_b));
}

/// True when an edge of each block are a potential contact pair (Wang et al. 2021, eqs. 23-26): both blocks
/// lie on their own sides of the normal of their parallelogram, which is given. Of edges parallel to
/// rounding, it tells whether that normal, as rounded, can serve.
inline bool is_edge_pair(const SeenEdge& a, const SeenEdge& b, const Vector<3>& normal) {
  return normal != Vector<3>::Zero() && is_outer_normal(a, normal) && is_outer_normal(b, -normal);
}
inline bool is_edge_pair(const SeenEdge& a, const SeenEdge& b) {
  return is_edge_pair(a, b, Parallelogram(a, b.along).normal());
}

/// Unit normal of a potential pair's half-space, turned so that it points from a to b. Not for two vertices.
inline Vector<3> normal_of(const SeenOutline& a, const SeenOutline& b, const PotentialPair<3>& pair) {
  if (pair.kind == PotentialPair<3>::face_vertex) return a.normal(pair.a);
  if (pair.kind == PotentialPair<3>::vertex_face) return -b.normal(pair.b);
  return edge_pair_normal(a, pair.a, b, pair.b);
}

/// A side of a facet of the Minkowski difference: an edge of one block and a vertex of the other. Across it
/// the normal turns about the edge towards the outer normal of a face at it.
struct FacetSide {
  int owner;    // whose edge: 0 block a, 1 block b
  int edge;     // of the owner
  int towards;  // face of the owner
  int vertex;   // of the other block
};

/// The side at an edge of the face, for the facet of a face of block `owner` and the other's vertex.
FacetSide side_along(const Topology& owner_topology, int owner, int face, int edge, int vertex);

/// The side at an end, `ending`, of one edge, for the facet of an edge of each block. The end belongs to the
/// block that is not `owner`.
FacetSide side_at_end(const SeenOutline& owner_block, int owner, int edge, const SeenOutline& other,
                      int ending, int vertex);

/// A potential pair and its unit normal from a to b.
struct Facet {
  PotentialPair<3> pair;
  Vector<3> normal;
};

/// The facet on the other side, of one whose unit normal from a to b is given. The normal turns about the
/// side's edge until another edge at the vertex comes to lie in the plane, or else until the face does.
Facet facet_across(const SeenOutline& a, const SeenOutline& b, const FacetSide& side,
                   const Vector<3>& normal);

/// Visits the sides of a facet. Of a pair of two edges parallel to rounding they need not all be there.
template <class Visitor>
void for_each_side(const SeenOutline& a, const SeenOutline& b, const PotentialPair<3>& pair,
                   Visitor&& visit) {
  if (pair.kind == PotentialPair<3>::edge_edge) {
    const Topology &of_a = *a.topology, &of_b = *b.topology;
    visit(side_at_end(a, 0, pair.a, b, pair.b, of_b.edge_start[pair.b]));
    visit(side_at_end(a, 0, pair.a, b, pair.b, of_b.edge_end[pair.b]));
    visit(side_at_end(b, 1, pair.b, a, pair.a, of_a.edge_start[pair.a]));
    visit(side_at_end(b, 1, pair.b, a, pair.a, of_a.edge_end[pair.a]));
    return;
  }
  const int owner = pair.kind == PotentialPair<3>::face_vertex ? 0 : 1;
  const Topology& topology = owner == 0 ? *a.topology : *b.topology;
  const int face = owner == 0 ? pair.a : pair.b;
  const int vertex = owner == 0 ? pair.b : pair.a;
  for (int k = topology.first_of_face[face]; k < topology.first_of_face[face + 1]; ++k)
    visit(side_along(topology, owner, face, topology.face_edge[k], vertex));
}

}  // namespace halfspace
