#pragma once

#include "detect/contact.h"
#include "geometry/outline.h"

namespace halfspace {

/// A violated potential pair, or the pair of least depth when none is violated, and its gap.
struct Separation {
  double gap = 0;
  PotentialPair pair;
};

/// The vertex that lies deepest along the outer normal of the other block's half-space, that is the vertex which forms a
/// potential contact pair with it (Wang et al. 2021, eq. 9): both its neighbours lie farther out.
int deepest_vertex(const Outline<2>& block, const Vector<2>& normal);

/// The same, found by a walk from a vertex near it.
int deepest_vertex(const Outline<2>& block, const Vector<2>& normal, int hint);

/// Gap of an edge: distance of the other block's deepest vertex from the half-space, below 0 when it is inside (eq. 10).
/// `to_other` leads from the owner's centroid to the other's.
inline double edge_gap(const Outline<2>& owner, int edge, const Outline<2>& other, int vertex, const Vector<2>& to_other) {
  const Vector<2> normal = owner.normal(edge);
  return (normal.dot(other.vertex(vertex)) + normal.dot(to_other)) - owner.offset[edge];
}

/// Judges all potential contact pairs, and stops at the first block that has a violated one (eqs. 12-16).
/// `to_b` leads from the centroid of a to that of b; both outlines are in the same orientation.
Separation find_separation(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b);

}  // namespace halfspace
