#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// Does a line parallel to that between the centroids meet both edges, that of b behind that of a? Then the
/// segments from these points to the centroids of their blocks cross, and the blocks touch. Equivalently, the
/// origin is inside the pyramid over the facet of the Minkowski difference with the difference of the
/// centroids as its apex (docs/theory.md). `across` is the cross product of the edges, `between` the vector
/// between their starts.
inline bool edges_cross(const Vector<3>& along_a, const Vector<3>& along_b, const Vector<3>& across,
                        const Vector<3>& between, const Vector<3>& to_b) {
  // between + share_b along_b + depth to_b = share_a along_a, by Cramer's rule: all three multiplied by
  // `whole`.
  const Vector<3> aside = cross_product(to_b, between);
  const double sign = across.dot(to_b) < 0 ? -1 : 1;
  const double whole = sign * across.dot(to_b);
  const double depth = -sign * across.dot(between);
  const double share_a = sign * along_b.dot(aside);
  const double share_b = sign * along_a.dot(aside);
  return whole > 0 && depth >= 0 && share_a >= 0 && share_a <= whole && share_b >= 0 && share_b <= whole;
}

}  // namespace halfspace
