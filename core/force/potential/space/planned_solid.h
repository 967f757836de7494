#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "force/potential/space/division_record.h"

namespace halfspace {

inline bool has_two(std::uint64_t set) { return (set & (set - 1)) != 0; }

template <class Visit>
void for_each(std::uint64_t set, Visit visit) {
  for (; set != 0; set &= set - 1) visit(std::countr_zero(set));
}

/// A convex solid, given by the planes that meet at each of its corners. There are two sorts of planes, so
/// that a set of each sort is one number.
class PlannedSolid {
 public:
  static constexpr std::size_t max_corners = 64;

  /// False when there are too many.
  bool add_corner(int number, const Vector<3>& at, FaceSet first_sort, FaceSet second_sort);

  /// Divides the solid into tetrahedra with one common corner. `outward(sort, plane)` returns the outward
  /// normal. False when a facet is missing: each edge must have two, one on either side.
  template <class Outward>
  bool divide(Outward outward) {
    merge_planes();
    find_edges();
    bool is_closed = true;
    for (int sort = 0; sort < 2; ++sort) {
      for_each(met_[sort], [&](int plane) {
        const CornerSet corners = on_[sort][plane];
        if (!has_two(corners & (corners - 1))) return;  // fewer than three corners
        is_closed = is_closed && add_facet(corners, outward(sort, plane));
      });
    }
    return is_closed && std::equal(to_.begin(), to_.begin() + count_, from_.begin());
  }
  /// The common corner of the tetrahedra.
  int top() const { return number_[top_]; }
  /// The other corners of each tetrahedron, counter-clockwise seen from outside.
  std::span<const std::array<int, 3>> triangles() const { return {triangles_.data(), triangle_count_}; }

 private:
  using CornerSet = std::uint64_t;

  void merge_planes();
  void find_edges();
  bool add_facet(CornerSet corners, const Vector<3>& outward);
  bool add_edges(std::span<const std::size_t> loop);
  Vector<3> area_of(std::span<const std::size_t> loop) const;

  std::size_t count_ = 0;
  std::size_t top_ = 0;
  std::array<int, max_corners> number_;
  std::array<Vector<3>, max_corners> at_;
  std::array<std::array<FaceSet, 2>, max_corners> planes_;  // of each corner
  CornerSet on_[2][max_near_faces] = {};                    // corners in each plane
  FaceSet met_[2] = {};
  std::array<CornerSet, max_corners> neighbors_;      // along edges
  std::array<CornerSet, max_corners> to_{}, from_{};  // along edges of facets, as these go around
  std::array<std::array<int, 3>, 2 * max_corners> triangles_;
  std::size_t triangle_count_ = 0;
};

}  // namespace halfspace
