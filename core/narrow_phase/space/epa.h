#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "geometry/tolerances.h"
#include "narrow_phase/space/simplex.h"
#include "simd/indexed_lanes.h"

namespace halfspace {

/// The plane of a facet.
struct PolytopeFacet {
  Vector<3> normal;  // outer, unit
  double offset;     // from the origin
};

/// A polytope of corners of a Minkowski difference around the origin, expanded towards the facet nearest to
/// the origin (van den Bergen 2003, section 4.3.8): the blocks' potential contact pair of minimum depth.
///
/// Always inlined, so that its lanes are as wide as those of the caller.
template <class Four>
class ExpandingPolytope {
 public:
  /// Requires a tetrahedron around the origin.
  [[gnu::always_inline]] explicit ExpandingPolytope(const Corner* tetrahedron);

  /// Outer normal of the facet nearest to the origin, of any length.
  Vector<3> normal_of_nearest() const { return {nx_[nearest_], ny_[nearest_], nz_[nearest_]}; }
  /// False when a point is outside the nearest facet by more than rounding.
  bool is_behind_nearest(const Vector<3>& p) const { return normal_of_nearest().dot(p) <= limit_[nearest_]; }
  /// The plane of the nearest facet.
  PolytopeFacet nearest() const {
    const Vector<3> normal = normal_of_nearest().normalized();
    return {normal, normal.dot(corner_of_nearest(2).at)};  // the tip, as in its limit
  }
  /// One of the three corners of the nearest facet.
  Corner corner_of_nearest(int i) const {
    const int c = triangles_[nearest_][i];
    return {{at_[c][0], at_[c][1], at_[c][2]}, vertex_of_a_[c], vertex_of_b_[c]};
  }
  /// The rounding error of distances.
  double rounding() const { return rounding_; }
  /// Adds a corner. False when it is outside of no facet, to rounding, or when there is no room.
  [[gnu::always_inline]] bool expand(const Corner& c);

 private:
  static constexpr int max_corners = 128;
  static constexpr int max_facets = 2 * max_corners;  // by Euler's formula, with four spare
  static constexpr int lanes = 4;

  /// The corners of a facet, counter-clockwise seen from outside. Packed into one word, as reading a whole
  /// that was just written in parts is slow.
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
  /// A facet, and the squared distance of its plane from the origin.
  struct Distance {
    double square;  // < 0 where rounding has put the origin outside
    int facet;
  };
  /// The facets visible from a point, and the nearest of the others to the origin.
  struct Visible {
    std::uint64_t bits[max_facets / 64];
    int words;
    Distance nearest_other;

    bool has(int f) const { return bits[f / 64] >> f % 64 & 1; }
  };
  /// Places for new facets, and their edges opposite to the new corner.
  struct Horizon {
    int count = 0;
    Edge edges[3 * max_facets + lanes];
    int place_count = 0;
    int places[max_facets + lanes];
  };

  void put_corner(int i, const Corner& c) {
    at_[i][0] = c.at.x();
    at_[i][1] = c.at.y();
    at_[i][2] = c.at.z();
    vertex_of_a_[i] = c.a;
    vertex_of_b_[i] = c.b;
    last_horizon_[i] = i;
  }
  [[gnu::always_inline]] void find_visible(const Vector<3>& from, Visible& visible);
  [[gnu::always_inline]] void find_horizon(const Visible& visible, Horizon& horizon) const;
  bool is_pinched(const Horizon& horizon);
  [[gnu::always_inline]] void put_fan(const Edge* edges, int count, int tip, const int* places,
                                      Distance& nearest);
  void forget_facet(int f);
  [[gnu::always_inline]] void forget_four_facets(int first);

  double at_[max_corners][4];  // three, and one so that no corner straddles cache lines
  int vertex_of_a_[max_corners], vertex_of_b_[max_corners];
  int last_horizon_[max_corners];  // index of the last new corner whose horizon had it
  Triangle triangles_[max_facets];
  // Per facet, read four at a time: normal of any length, height along it up to which a point is not outside,
  // and squared distance. The nearest is found without a square root.
  double nx_[max_facets + lanes], ny_[max_facets + lanes], nz_[max_facets + lanes],
      limit_[max_facets + lanes], distance_square_[max_facets + lanes];
  // The facet with the edge from one corner to another on its left.
  std::uint8_t facet_at_[max_corners][max_corners];
  int corner_count_ = 0;
  int facet_count_ = 0;
  int nearest_ = 0;
  double rounding_ = 0;
};

template <class Four>
inline ExpandingPolytope<Four>::ExpandingPolytope(const Corner* tetrahedron) {
  double size = 0;
  for (int i = 0; i < 4; ++i) size = std::max(size, tetrahedron[i].at.cwiseAbs().maxCoeff());
  rounding_ = 8 * machine_epsilon * size;
  // Counter-clockwise seen from outside when corner 3 is behind the plane of the others.
  const Vector<3> base = tetrahedron[0].at;
  const double volume =
      cross_product(Vector<3>(tetrahedron[1].at - base), Vector<3>(tetrahedron[2].at - base))
          .dot(tetrahedron[3].at - base);
  put_corner(0, tetrahedron[0]);
  put_corner(1, tetrahedron[volume > 0 ? 2 : 1]);
  put_corner(2, tetrahedron[volume > 0 ? 1 : 2]);
  put_corner(3, tetrahedron[3]);
  corner_count_ = 4;
  facet_count_ = 4;
  forget_four_facets(4);
  const Edge below[] = {{1, 0}, {2, 1}, {0, 2}, {0, 2}}, first[] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}};
  const int places[] = {0, 1, 2, 3};
  Distance nearest{HUGE_VAL, 0};
  put_fan(below, 3, 3, places, nearest);
  put_fan(first, 1, 2, places + 3, nearest);
  nearest_ = nearest.facet;
}

/// Makes the facets between edges and a tip, four at a time.
template <class Four>
inline void ExpandingPolytope<Four>::put_fan(const Edge* edges, int count, int tip, const int* places,
                                             Distance& nearest) {
  const Four zero = all_four<Four>(0), apex_x = all_four<Four>(at_[tip][0]),
             apex_y = all_four<Four>(at_[tip][1]), apex_z = all_four<Four>(at_[tip][2]);
  for (int first = 0; first < count; first += lanes) {
    const auto ends = [&](int Edge::*end, int c) __attribute__((always_inline)) {
      const auto at = [&](int lane) { return at_[edges[first + lane].*end][c]; };
      return four_of<Four>(at(0), at(1), at(2), at(3));
    };
    const Four from_x = ends(&Edge::from, 0) - apex_x, to_x = ends(&Edge::to, 0) - apex_x;
    const Four from_y = ends(&Edge::from, 1) - apex_y, to_y = ends(&Edge::to, 1) - apex_y;
    const Four from_z = ends(&Edge::from, 2) - apex_z, to_z = ends(&Edge::to, 2) - apex_z;
    const Four nx = from_y * to_z - from_z * to_y, ny = from_z * to_x - from_x * to_z,
               nz = from_x * to_y - from_y * to_x;
    const Four square = nx * nx + ny * ny + nz * nz, height = nx * apex_x + ny * apex_y + nz * apex_z;
    const Four limit = height + all_four<Four>(rounding_) * sqrt(square);
    // Collinear corners span no plane: such a facet is never the nearest, and nothing is outside of it.
    const Four divisor = select_less(zero, square, square, all_four<Four>(1));
    const Four distance_square =
        select_less(zero, square, height / divisor * select_less(height, zero, zero - height, height),
                    all_four<Four>(HUGE_VAL));
    for (int lane = 0; lane < lanes && first + lane < count; ++lane) {
      const auto [start, end] = edges[first + lane];
      const int f = places[first + lane];
      triangles_[f] = Triangle(start, end, tip);
      facet_at_[start][end] = facet_at_[end][tip] = facet_at_[tip][start] = std::uint8_t(f);
      nx_[f] = nx[lane];
      ny_[f] = ny[lane];
      nz_[f] = nz[lane];
      limit_[f] = limit[lane];
      distance_square_[f] = distance_square[lane];
      nearest = distance_square[lane] < nearest.square ? Distance{distance_square[lane], f} : nearest;
    }
  }
}

/// Removes a facet: it is never the nearest, and nothing is outside of it.
template <class Four>
inline void ExpandingPolytope<Four>::forget_facet(int f) {
  nx_[f] = ny_[f] = nz_[f] = limit_[f] = 0;
  distance_square_[f] = HUGE_VAL;
}

/// Initializes unused places.
template <class Four>
inline void ExpandingPolytope<Four>::forget_four_facets(int first) {
  store_four(nx_ + first, all_four<Four>(0));
  store_four(ny_ + first, all_four<Four>(0));
  store_four(nz_ + first, all_four<Four>(0));
  store_four(limit_ + first, all_four<Four>(0));
  store_four(distance_square_ + first, all_four<Four>(HUGE_VAL));
}

/// Without branches, as the visible facets are unpredictable.
template <class Four>
inline void ExpandingPolytope<Four>::find_visible(const Vector<3>& from, Visible& visible) {
  const Four x = all_four<Four>(from.x()), y = all_four<Four>(from.y()), z = all_four<Four>(from.z());
  const Four never = all_four<Four>(HUGE_VAL);
  Four index = four_of<Four>(0, 1, 2, 3);
  Indexed<Four> least = {never, index};
  visible.words = 0;
  for (int word = 0; word < facet_count_; word += 64) {
    std::uint64_t bits = 0;
    for (int f = word; f < std::min(word + 64, facet_count_); f += lanes) {
      const Four height =
          load_four<Four>(nx_ + f) * x + load_four<Four>(ny_ + f) * y + load_four<Four>(nz_ + f) * z;
      const Four clearance = load_four<Four>(limit_ + f) - height;
      bits |= std::uint64_t(signs_of_four(clearance)) << f % 64;
      least = min(
          least,
          {select_less(clearance, all_four<Four>(0), never, load_four<Four>(distance_square_ + f)), index});
      index = index + all_four<Four>(lanes);
    }
    visible.bits[visible.words++] = bits;
  }
  const IndexedLanes nearest = reduce_min(least);
  visible.nearest_other = {nearest.value[0], int(nearest.index[0])};
}

/// The horizon is the edges between visible and hidden facets.
template <class Four>
inline void ExpandingPolytope<Four>::find_horizon(const Visible& visible, Horizon& horizon) const {
  for (int word = 0; word < visible.words; ++word) {
    for (std::uint64_t left = visible.bits[word]; left != 0; left &= left - 1) {
      const int f = 64 * word + std::countr_zero(left);
      horizon.places[horizon.place_count++] = f;
      const Triangle t = triangles_[f];
      for (const Edge& e : {Edge{t[0], t[1]}, Edge{t[1], t[2]}, Edge{t[2], t[0]}}) {
        horizon.edges[horizon.count] = e;
        horizon.count += !visible.has(facet_at_[e.to][e.from]);
      }
    }
  }
}

/// Rounding may break the surface: then the horizon visits a corner twice, and edges would have more than two
/// facets.
template <class Four>
inline bool ExpandingPolytope<Four>::is_pinched(const Horizon& horizon) {
  bool is_pinched = false;
  for (int i = 0; i < horizon.count; ++i) {
    int& last = last_horizon_[horizon.edges[i].from];
    is_pinched |= last == corner_count_;
    last = corner_count_;
  }
  return is_pinched;
}

/// Replaces the visible facets by those between the horizon and the new corner.
template <class Four>
inline bool ExpandingPolytope<Four>::expand(const Corner& c) {
  Visible visible;
  find_visible(c.at, visible);
  Horizon horizon;
  find_horizon(visible, horizon);
  const int added = horizon.count - horizon.place_count;
  if (horizon.count == 0 || is_pinched(horizon) || corner_count_ == max_corners ||
      facet_count_ + added > max_facets)
    return false;
  // Each corner adds two facets; if it hides others, some places remain empty.
  for (int i = horizon.count; i < horizon.place_count; ++i) forget_facet(horizon.places[i]);
  for (int i = 0; i < added; ++i) horizon.places[horizon.place_count++] = facet_count_++;
  forget_four_facets(facet_count_);
  for (int i = 0; i < lanes; ++i) horizon.edges[horizon.count + i] = horizon.edges[0];
  const int tip = corner_count_++;
  put_corner(tip, c);
  put_fan(horizon.edges, horizon.count, tip, horizon.places, visible.nearest_other);
  nearest_ = visible.nearest_other.facet;
  return true;
}

}  // namespace halfspace
