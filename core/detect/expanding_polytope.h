#pragma once

#include <cstdint>

#include "detect/simplex.h"

namespace halfspace {

/// A polytope of corners of a Minkowski difference around the origin, that grows towards the facet nearest to
/// the origin (van den Bergen 2003, section 4.3.8): the blocks' potential contact pair of least depth.
class ExpandingPolytope {
 public:
  struct Facet {
    const Corner* corner[3];
    Vector<3> normal;  // outer, unit
    double offset;     // from the origin
  };

  /// From a tetrahedron around the origin.
  explicit ExpandingPolytope(const Corner* tetrahedron);

  /// The facet nearest to the origin.
  Facet nearest() const;
  /// Below this a distance is rounding.
  double rounding() const { return rounding_; }
  /// True when there is room for one more corner.
  bool has_room() const { return corner_count_ < most_corners; }
  /// Takes in a corner that lies outside.
  void expand(const Corner& c);

 private:
  static constexpr int most_corners = 128;
  static constexpr int most_facets = 2 * most_corners;  // by Euler's formula, and two to spare

  /// The corners of a facet, counter-clockwise seen from outside. In one word: what has just been written
  /// part by part is slow to read as a whole.
  class Triangle {
   public:
    Triangle() = default;
    Triangle(int i, int j, int k) : corners_(unsigned(i) | unsigned(j) << 8 | unsigned(k) << 16) {}
    int operator[](int i) const { return int(corners_ >> 8 * i & 0xff); }

   private:
    std::uint32_t corners_;
  };
  struct Edge {
    int from;
    int to;
  };

  void add_corner(const Corner& c);
  void put_two(const Triangle& first, int first_place, const Triangle& second, int second_place);
  void forget_facet(int f);
  int find_visible(const Vector<3>& from, int* visible);
  int find_horizon(const int* visible, int visible_count, Edge* horizon);

  Corner corners_[most_corners];
  std::uint64_t edges_from_[most_corners][2];  // where find_horizon() ticks off edges: all 0 in between
  Triangle triangles_[most_facets];
  // Planes of the facets, read two at a time.
  double nx_[most_facets], ny_[most_facets], nz_[most_facets], offset_[most_facets];
  int corner_count_ = 0;
  int facet_count_ = 0;
  int nearest_ = 0;
  double rounding_ = 0;
};

}  // namespace halfspace
