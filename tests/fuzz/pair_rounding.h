#pragma once

// The difference that rounding allows between two answers about one pair of shapes.

#include "fuzz/geometry.h"

namespace halfspace_fuzz {

/// How far the shape's half-spaces and vertices may be off each other, see off_plane() of shapes.cpp, comes
/// in by the coordinates that it was made from.
inline double rounding_of(const hs_shape* shape) {
  const hs_shape_properties p = halfspace_test::properties_of(shape);
  const double reach = p.bounding_radius + halfspace_test::length(halfspace_test::vector_of(p.centroid));
  return (p.dimension == 2 ? 32 : 1024) * 0x1p-52 * reach;
}

/// Of a gap between shapes whose centroids are `apart`: that of both shapes, and what
/// tests/oracles/exact_pair.h counts.
inline double rounding_of_gap(const hs_shape* a, const hs_shape* b, double apart) {
  const double radii =
      halfspace_test::properties_of(a).bounding_radius + halfspace_test::properties_of(b).bounding_radius;
  return rounding_of(a) + rounding_of(b) + 2 * 48 * 0x1p-53 * (radii + apart);
}

/// The gap at a corner is along another direction than that of the least depth, by what the vertex zone
/// allows.
inline double aside(const hs_shape* a, const hs_shape* b, double vertex_zone) {
  const double radii =
      halfspace_test::properties_of(a).bounding_radius + halfspace_test::properties_of(b).bounding_radius;
  return 2 * vertex_zone * radii;
}

inline bool touches(const hs_contact& contact) { return contact.type != HS_CONTACT_NONE; }

/// Certainly apart or certainly overlapping, and told otherwise.
inline bool contradicts(const hs_contact& one, const hs_contact& other, double rounding) {
  return touches(one) != touches(other) && (std::abs(one.gap) > rounding || std::abs(other.gap) > rounding);
}

}  // namespace halfspace_fuzz
