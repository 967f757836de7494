#pragma once

// The separation of two polyhedra by brute force, in double: all faces against all vertices, all edges
// against all edges.

#include "oracles/polyhedron_3d.h"

namespace halfspace_test {

/// A facet of the Minkowski difference of two polyhedra: a face of one, or an edge of each.
struct MinkowskiFacet {
  enum Kind { face_of_a, face_of_b, edges };
  Kind kind;
  int a;          ///< its face or edge, if of a
  int b;          ///< its face or edge, if of b
  Point3 normal;  ///< unit, from a to b, in the frame of a
  double doubt;   ///< bound of the normal's rounding, rad
  double reach;   ///< of both polyhedra together, along the normal
};

/// The facets of two polyhedra as they are turned; how far they are apart does not change them. Facets that
/// might be none, to rounding, are among them: that does no harm, as every direction shows a separation that
/// there is.
class MinkowskiFacets {
 public:
  MinkowskiFacets(const PlacedPolyhedron& a, const PlacedPolyhedron& b);

  /// The largest gap of all facets, when the centre of b is at `apart` in the frame of a: the distance by
  /// which b overlaps a is its negative.
  struct Separation {
    double gap;
    Point3 normal;  ///< in the frame of a
  };
  Separation separation(const Point3& apart) const;

  /// How far b has to go from `start` along `direction` (in the frame of a) for the separation to be `gap`.
  /// @param gap above the separation at the start
  double distance_for(const Point3& start, const Point3& direction, double gap) const;

  const std::vector<MinkowskiFacet>& facets() const { return facets_; }

  /// Pairs of edges so close to parallel that rounding leaves their normal unknown. Not facets, or facets so
  /// thin that the separation is the same without them to rounding; its sign might not be.
  const std::vector<MinkowskiFacet>& parallel_edges() const { return parallel_edges_; }

  /// Sum of both bounding radii.
  double radii() const { return radii_; }

 private:
  void add(MinkowskiFacet facet);

  Points3 a_;
  Points3 b_;
  double radii_ = 0;
  std::vector<MinkowskiFacet> facets_;
  std::vector<MinkowskiFacet> parallel_edges_;
};

inline double gap_of(const MinkowskiFacet& facet, const Point3& apart) {
  return dot(facet.normal, apart) - facet.reach;
}

/// The largest gap along all axes of the theorem of separating axes: every face's normal and every product of
/// an edge of each, whether a facet or not. Of an overlap it is the largest gap of the facets, as that is the
/// largest of all directions.
double largest_gap_of_all_axes(const PlacedPolyhedron& a, const PlacedPolyhedron& b);

/// Where the centre of b is, in the frame of a.
Point3 apart(const PlacedPolyhedron& a, const PlacedPolyhedron& b);

}  // namespace halfspace_test
