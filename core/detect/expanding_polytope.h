#pragma once

#include "detect/simplex.h"

namespace halfspace {

/// A polytope of corners of a Minkowski difference around the origin, that grows towards the facet nearest to
/// the origin (van den Bergen 2003, section 4.3.8): the blocks' potential contact pair of least depth.
class ExpandingPolytope {
 public:
  struct Facet {
    int corner[3];
    Vector<3> normal;  // outer, unit
    double offset;     // from the origin
  };

  /// From a tetrahedron around the origin.
  explicit ExpandingPolytope(const Corner* tetrahedron);

  const Facet& nearest() const;
  const Corner& corner(int i) const { return corners_[i]; }
  /// Below this a distance is rounding.
  double rounding() const { return rounding_; }
  /// True when there is room for one more corner.
  bool has_room() const {
    return corner_count_ < most_corners && facet_count_ <= most_facets - 2 * most_corners;
  }
  /// Takes in a corner that lies outside.
  void expand(const Corner& c);

 private:
  static constexpr int most_corners = 128;
  static constexpr int most_facets = 512;

  struct Edge {
    int from;
    int to;
  };

  void add_facet(int i, int j, int k);
  void remove_visible(const Vector<3>& from, Edge* horizon, int& horizon_count);

  Corner corners_[most_corners];
  Facet facets_[most_facets];
  int corner_count_ = 0;
  int facet_count_ = 0;
  double rounding_ = 0;
};

}  // namespace halfspace
