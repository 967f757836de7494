#include "force/potential/space/planned_solid.h"

#include <algorithm>

namespace halfspace {
namespace {

std::uint64_t set_of(std::size_t corner) { return std::uint64_t(1) << corner; }

}  // namespace

bool PlannedSolid::add_corner(int number, const Vector<3>& at, FaceSet first_sort, FaceSet second_sort) {
  if (count_ == max_corners) return false;
  number_[count_] = number;
  at_[count_] = at;
  planes_[count_] = {first_sort, second_sort};
  for_each(first_sort, [&](int plane) { on_[0][plane] |= set_of(count_); });
  for_each(second_sort, [&](int plane) { on_[1][plane] |= set_of(count_); });
  met_[0] |= first_sort;
  met_[1] |= second_sort;
  ++count_;
  return true;
}

/// Planes with the same corners are one, as where blocks are flush: drops all but the first.
void PlannedSolid::merge_planes() {
  for_each(met_[1], [&](int second) {
    bool is_known = false;
    for_each(met_[0], [&](int first) { is_known |= on_[0][first] == on_[1][second]; });
    if (!is_known) return;
    met_[1] &= ~face_set(std::size_t(second));
    for (std::size_t c = 0; c < count_; ++c) planes_[c][1] &= ~face_set(std::size_t(second));
  });
}

/// Corners that share two planes are connected by an edge. The top is the corner with the most edges, which
/// gives the fewest tetrahedra.
void PlannedSolid::find_edges() {
  std::fill_n(neighbors_.begin(), count_, 0);
  for (std::size_t c = 0; c < count_; ++c) {
    for (std::size_t d = 0; d < c; ++d) {
      const FaceSet first = planes_[c][0] & planes_[d][0], second = planes_[c][1] & planes_[d][1];
      if (!has_two(first) && !has_two(second) && (first == 0 || second == 0)) continue;
      neighbors_[c] |= set_of(d);
      neighbors_[d] |= set_of(c);
    }
  }
  int most = 0;
  for (std::size_t c = 0; c < count_; ++c) {
    const int edges = std::popcount(neighbors_[c]);
    if (edges <= most) continue;
    most = edges;
    top_ = c;
  }
}

/// Goes around the facet from corner to corner.
bool PlannedSolid::add_facet(CornerSet corners, const Vector<3>& outward) {
  std::array<std::size_t, max_corners> around;
  std::size_t size = 0;
  CornerSet rest = corners, next = corners;
  while (next != 0) {
    const std::size_t corner = std::size_t(std::countr_zero(next));
    around[size++] = corner;
    rest &= ~set_of(corner);
    next = neighbors_[corner] & rest;
  }
  const std::span<std::size_t> loop(around.data(), size);
  if (rest != 0 || (neighbors_[loop.back()] & set_of(loop.front())) == 0) return false;
  if (area_of(loop).dot(outward) < 0) std::reverse(loop.begin(), loop.end());
  if (!add_edges(loop)) return false;
  if ((corners & set_of(top_)) != 0) return true;
  if (triangle_count_ + size > triangles_.size()) return false;
  for (std::size_t k = 2; k < size; ++k)
    triangles_[triangle_count_++] = {number_[loop[0]], number_[loop[k - 1]], number_[loop[k]]};
  return true;
}

bool PlannedSolid::add_edges(std::span<const std::size_t> loop) {
  std::size_t from = loop.back();
  for (const std::size_t to : loop) {
    if ((to_[from] & set_of(to)) != 0) return false;
    to_[from] |= set_of(to);
    from_[to] |= set_of(from);
    from = to;
  }
  return true;
}

Vector<3> PlannedSolid::area_of(std::span<const std::size_t> loop) const {
  Vector<3> area = Vector<3>::Zero(), previous = at_[loop[1]] - at_[loop[0]];
  for (const std::size_t corner : loop.subspan(2)) {
    const Vector<3> arm = at_[corner] - at_[loop[0]];
    area += cross_product(previous, arm);
    previous = arm;
  }
  return area;
}

}  // namespace halfspace
