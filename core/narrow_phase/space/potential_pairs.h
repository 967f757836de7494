#pragma once

#include <cmath>

#include "geometry/tolerances.h"
#include "narrow_phase/contact.h"
#include "narrow_phase/space/seen_outline.h"

namespace halfspace {

/// The vector from an edge's start to its end.
inline Vector<3> edge_vector(const SeenOutline& block, int edge) {
  return block.vertex(block.topology->edge_end[edge]) - block.vertex(block.topology->edge_start[edge]);
}

/// The face at a vertex whose normal is nearest to a direction.
int face_along(const SeenOutline& block, int vertex, const Vector<3>& direction);

/// An edge of a block and the outer normals of its faces, read once for repeated use.
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

/// Is a block behind the plane through one of its edges with a given outer normal? The normal must be
/// orthogonal to the edge.
inline bool is_outer_normal(const SeenEdge& edge, const Vector<3>& normal) {
  // Both vectors point from the edge into its face.
  const Vector<3> into_left = cross_product(edge.left, edge.along);
  const Vector<3> into_right = cross_product(edge.along, edge.right);
  return normal.dot(into_left) <= 0 && normal.dot(into_right) <= 0;
}

/// Are two edges parallel within an angle far above rounding and far below relevant angles? Then their common
/// normal is dominated by rounding, and their facet of the Minkowski difference is a sliver.
inline bool are_all_but_parallel(double square_of_cross_product, double square_a, double square_b) {
  return square_of_cross_product <= strictly_parallel * strictly_parallel * square_a * square_b;
}
inline bool are_all_but_parallel(const Vector<3>& along_a, const Vector<3>& along_b) {
  return are_all_but_parallel(cross_product(along_a, along_b).squaredNorm(), along_a.squaredNorm(),
                              along_b.squaredNorm());
}

/// The parallelogram of an edge of each block.
struct Parallelogram {
  Vector<3> across;  // normal to both edges; its length is the area
  double square;     // of the area
  double sense;      // 1 or, where the edge of a turns clockwise about `normal` towards that of b, -1

  Parallelogram(const SeenEdge& a, const Vector<3>& along_b)
      : across(cross_product(a.along, along_b)),
        square(across.squaredNorm()),
        sense(across.dot(a.left + a.right) < 0 ? -1 : 1) {}

  /// The unit normal on the outer side of a, by the faces at a's edge: for a potential pair it points from a
  /// to b. Zero when the edges are exactly parallel.
  Vector<3> normal() const {
    const double area = std::sqrt(square);
    return (area == 0 ? 0 : sense / area) * across;
  }
};

inline Vector<3> edge_pair_normal(const SeenOutline& a, int edge_of_a, const Vector<3>& along_b) {
  return Parallelogram(SeenEdge(a, edge_of_a), along_b).normal();
}
inline Vector<3> edge_pair_normal(const SeenOutline& a, int edge_of_a, const SeenOutline& b, int edge_of_b) {
  return edge_pair_normal(a, edge_of_a, edge_vector(b, edge_of_b));
}

/// Are an edge of each block a potential contact pair (Wang et al. 2021, eqs. 23 and 24)? That is, are both
/// blocks on their own sides of their parallelogram, with the given normal? For edges parallel to rounding
/// the result is for the rounded normal.
inline bool is_edge_pair(const SeenEdge& a, const SeenEdge& b, const Vector<3>& normal) {
  return normal != Vector<3>::Zero() && is_outer_normal(a, normal) && is_outer_normal(b, -normal);
}
inline bool is_edge_pair(const SeenEdge& a, const SeenEdge& b) {
  return is_edge_pair(a, b, Parallelogram(a, b.along).normal());
}

/// Unit normal of a potential pair's half-space, oriented from a to b. Not for two vertices.
inline Vector<3> normal_of(const SeenOutline& a, const SeenOutline& b, const PotentialPair<3>& pair) {
  if (pair.kind == PotentialPair<3>::face_vertex) return a.normal(pair.a);
  if (pair.kind == PotentialPair<3>::vertex_face) return -b.normal(pair.b);
  return edge_pair_normal(a, pair.a, b, pair.b);
}

/// A side of a facet of the Minkowski difference: an edge of one block and a vertex of the other. Across it
/// the normal rotates about the edge towards the outer normal of one of its faces.
struct FacetSide {
  int owner;    // of the edge: 0 block a, 1 block b
  int edge;     // of the owner
  int towards;  // face of the owner
  int vertex;   // of the other block
};

/// The side at an edge of the face, for the facet of a face of block `owner` and the other's vertex.
FacetSide side_along(const Topology& owner_topology, int owner, int face, int edge, int vertex);

/// The side at an end of the edge `ending`, for the facet of an edge of each block. The end belongs to the
/// block that is not `owner`.
FacetSide side_at_end(const SeenOutline& owner_block, int owner, int edge, const SeenOutline& other,
                      int ending, int vertex);

/// A potential pair and its unit normal from a to b.
struct Facet {
  PotentialPair<3> pair;
  Vector<3> normal;
};

/// The facet across a side, of one with the given unit normal from a to b. The normal rotates about the
/// side's edge until another edge at the vertex lies in the plane, or else until the face does.
Facet facet_across(const SeenOutline& a, const SeenOutline& b, const FacetSide& side,
                   const Vector<3>& normal);

/// Visits the sides of a facet. For two edges parallel to rounding some may be missing.
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
